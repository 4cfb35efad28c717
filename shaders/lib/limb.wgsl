// How much of a pixel the ellipsoid fills.
#import ellipsoid

// A pixel and the ellipsoid's limb or horizon: the share that the ellipsoid fills, how far off the limb is, and the step on the screen to
// the pixel on the sky's side.
struct Limb { share: f32, distance: Metres, beyond: vec2f }

fn limb_of(ray: Ray, direction: vec3f) -> Limb {
    let t = sqrt(max(ray.c, 0.0) / ray.a);
    let p = direction * t;
    let height = height_along(ray, t);
    // Pixels are seen under at most this angle.
    if abs(height) > 2.0 * t * frame.pixel_angle { return Limb(select(0.0, 1.0, height < 0.0), t, vec2f(0.0)); }
    // What a metre along the vertical is on the screen: the derivative of (right, up) / ahead.
    let vertical = normal_delta(p) + vec3f(0.0, 0.0, 1.0);
    let axes = mat3x3f(normalize(frame.ray_right), normalize(frame.ray_up), frame.ray_forward);
    let at = p * axes;
    let out = vertical * axes;
    let moved = out.xy / at.z - at.xy * (out.z / (at.z * at.z));
    let size = length(moved);
    let share = clamp(0.5 - height * size / frame.pixel_angle, 0.0, 1.0);
    return Limb(share, t, round(moved / max(size, 1e-20)) * vec2f(1.0, -1.0));
}
