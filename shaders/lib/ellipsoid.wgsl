// The ellipsoid about the eye, free of cancellation: every difference is formed before it is rounded.
#import frame

const MISS = -1.0;

fn quadric_times(p: vec3f) -> vec3f {
    let m = frame.quadric_mixed;
    return frame.quadric_diagonal * p + vec3f(m.x * p.y + m.y * p.z, m.x * p.x + m.z * p.z, m.y * p.x + m.z * p.y);
}

// Height above the ellipsoid at distance t along a unit ray from the eye; exact near it, 0.3 % of the height in space.
struct Ray { a: f32, b: f32, c: f32 }

fn ray_coefficients(direction: vec3f, gradient: vec3f, constant: f32) -> Ray {
    return Ray(dot(direction, quadric_times(direction)), dot(gradient, direction), constant);
}

fn eye_ray(direction: vec3f) -> Ray {
    return ray_coefficients(direction, frame.quadric_gradient, frame.quadric_constant);
}

fn height_along(ray: Ray, t: f32) -> Metres {
    let f = ray.c + t * (2.0 * ray.b + t * ray.a);
    return 2.0 * f / (sqrt(max(1.0 + 2.0 * f / frame.semi_major, 0.0)) + 1.0);
}

// Near and far distance to the shell `lift` metres above the ellipsoid; x > y when the ray misses it.
fn shell_hits(ray: Ray, lift: Metres) -> vec2f {
    let c = ray.c - lift * (1.0 + 0.5 * lift / frame.semi_major);
    let discriminant = ray.b * ray.b - ray.a * c;
    if discriminant < 0.0 { return vec2f(1.0, MISS); }
    // q has the sign of -b, so that nothing cancels (Numerical Recipes, 5.6).
    let q = -(ray.b + select(-1.0, 1.0, ray.b >= 0.0) * sqrt(discriminant));
    let t0 = q / ray.a;
    let t1 = select(c / q, t0, q == 0.0);
    return vec2f(min(t0, t1), max(t0, t1));
}

// Distance to the first hit of the ellipsoid in front of the eye, or MISS.
fn surface_hit(ray: Ray) -> f32 {
    let hits = shell_hits(ray, 0.0);
    if hits.y < hits.x || hits.y < 0.0 { return MISS; }
    return select(hits.x, hits.y, hits.x < 0.0);
}

// Whether a ray passes below the deepest trough and the flattest triangle, and a pixel inside the limb: what covers the ellipsoid covers
// such a pixel for certain, whatever its own ray has been rounded to.
fn is_inside_limb(ray: Ray) -> bool {
    let limb_distance = sqrt(max(ray.c, 0.0) / ray.a);
    let hits = shell_hits(ray, -500.0 - limb_distance * frame.pixel_angle);
    return hits.y > max(hits.x, 0.0);
}

// Normal of the ellipsoid through `p`, as its difference from the normal at the eye's foot, (0, 0, 1).
fn normal_delta(p: vec3f) -> vec3f {
    let g = frame.quadric_gradient + quadric_times(p);
    let n = g / length(g);
    if n.z < 0.0 { return n - vec3f(0.0, 0.0, 1.0); }
    return vec3f(n.xy, -dot(n.xy, n.xy) / (1.0 + n.z));
}

// Sine of the geodetic latitude minus that of the eye's foot.
fn sin_lat_delta(dn: vec3f) -> f32 {
    return dn.y * frame.cos_lat + dn.z * frame.sin_lat;
}

// The point of the ellipsoid whose normal differs by `dn` from that of the eye's foot; local metres.
fn surface_from_normal_delta(dn: vec3f) -> vec3f {
    let a2 = frame.semi_major * frame.semi_major;
    let flat2 = a2 - SEMI_MINOR * SEMI_MINOR;
    let pole = vec3f(0.0, frame.cos_lat, frame.sin_lat);
    let ds = sin_lat_delta(dn);
    let s = frame.sin_lat + ds;
    let nu = sqrt(a2 - flat2 * s * s);
    let nu0 = frame.foot_nu;
    let inverse_delta = flat2 * ds * (s + frame.sin_lat) / (nu * nu0 * (nu + nu0));
    let from_normal = (a2 * dn - flat2 * ds * pole) / nu;
    let from_radius = (vec3f(0.0, 0.0, a2) - flat2 * frame.sin_lat * pole) * inverse_delta;
    return from_normal + from_radius - vec3f(0.0, 0.0, frame.eye_altitude);
}

// Whether the waves at a distance are smaller than a quarter of a pixel, so that the ellipsoid is the surface.
fn waves_are_pixels(distance: Metres) -> bool {
    return distance * frame.pixel_angle > 4.0 * frame.crest_height;
}
