// Where clouds of water may be.
#import ellipsoid

const CLOUD_TOP: Metres = 2100.0;

// The part of a ray that is within the layer, as far as it is seen: distances; x > y where there is none.
fn layer_stretch(ray: Ray, far: Metres) -> vec2f {
    let outer = shell_hits(ray, CLOUD_TOP);
    let inner = shell_hits(ray, CLOUD_BASE);
    let altitude = frame.eye_altitude;
    let missed = (outer.x > outer.y) | (outer.y < 0.0);
    var first = select(0.0, outer.x, altitude > CLOUD_TOP);
    first = select(first, inner.y, altitude < CLOUD_BASE);
    let goes_below = (altitude >= CLOUD_BASE) & (inner.x <= inner.y) & (inner.x > 0.0);
    let last = min(select(outer.y, inner.x, goes_below), far);
    return select(vec2f(first, last), vec2f(1.0, 0.0), missed);
}
