// Sine, cosine and arctangent to 1e-7 everywhere: WGSL promises only 2^-11 for its own, which is kilometres on the globe.
// Polynomials: S. L. Moshier, Cephes (sinf, cosf, atanf).

struct SineCosine { sine: f32, cosine: f32 }

// For |x| up to a few turns.
fn sine_cosine(x: f32) -> SineCosine {
    let quarter = round(x * 0.63661977);
    // x - quarter * pi / 2 in two steps, so that nothing is lost.
    let r = (x - quarter * 1.5703125) - quarter * 4.8382679e-4;
    let r2 = r * r;
    let s = r * (1.0 + r2 * (-0.16666655 + r2 * (8.3321609e-3 + r2 * -1.9515296e-4)));
    let c = 1.0 + r2 * (-0.5 + r2 * (4.1666646e-2 + r2 * (-1.3887316e-3 + r2 * 2.4433157e-5)));
    switch u32(i32(quarter)) & 3u {
        case 1u: { return SineCosine(c, -s); }
        case 2u: { return SineCosine(-s, -c); }
        case 3u: { return SineCosine(-c, s); }
        default: { return SineCosine(s, c); }
    }
}

// The angle of (x, y), in (-pi, pi]; small angles keep their relative accuracy.
fn angle_of(y: f32, x: f32) -> f32 {
    let low = min(abs(x), abs(y));
    let high = max(max(abs(x), abs(y)), 1e-30);
    let steep = low > 0.41421356 * high;
    let t = select(low / high, (low - high) / (low + high), steep);
    let z = t * t;
    var a = t + t * z * (-0.33332949 + z * (0.19977711 + z * (-0.13877686 + z * 0.080537445)));
    a += select(0.0, 0.78539816, steep);
    if abs(y) > abs(x) { a = 1.5707963 - a; }
    if x < 0.0 { a = 3.1415927 - a; }
    return select(a, -a, y < 0.0);
}
