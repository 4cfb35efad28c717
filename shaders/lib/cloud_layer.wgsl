// Where clouds of water may be.
#import ellipsoid

const CLOUD_TOP: Metres = 2100.0;

// How far the air before an eye that stands under clouds over so much of its sky is lit as under a clear one: below them it is in their shadow, among
// them in part.
fn air_under(cover: f32) -> f32 {
    let below = 1.0 - saturate((frame.eye_altitude + frame.water_level - CLOUD_BASE) / (CLOUD_TOP - CLOUD_BASE));
    return 1.0 - below * cover * cover;
}

// Where a ray is within the layer, as far as it is seen: from `first` to `last`, distances, but for what lies between `leaves` and `returns`, where
// a sight that passes close over the sea is below it. `first` > `last`: nowhere.
struct Stretch { first: Metres, last: Metres, leaves: Metres, returns: Metres }

fn layer_stretch(ray: Ray, far: Metres) -> Stretch {
    let outer = shell_hits(ray, CLOUD_TOP);
    let inner = shell_hits(ray, CLOUD_BASE);
    let altitude = frame.eye_altitude;
    let is_missed = (outer.x > outer.y) | (outer.y < 0.0);
    let goes_below = (altitude >= CLOUD_BASE) & (inner.x <= inner.y) & (inner.x > 0.0);
    let returns = goes_below & (inner.y < far);
    let first = select(select(0.0, outer.x, altitude > CLOUD_TOP), inner.y, altitude < CLOUD_BASE);
    let ends = min(outer.y, far);
    let last = select(ends, min(inner.x, far), goes_below & !returns);
    return Stretch(select(first, 1.0, is_missed), select(last, 0.0, is_missed), select(last, inner.x, returns), select(last, inner.y, returns));
}

// The logarithm of a distance, over a kilometre.
fn way_of(distance: Metres) -> f32 { return log(max(distance, 1.0) / 1000.0); }
