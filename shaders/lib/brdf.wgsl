// Reflection at the rough sea: Fresnel, the sun's glitter, and the mean reflectance of what a pixel cannot resolve.

const WATER_INDEX = 1.333;

// Unpolarised Fresnel reflectance from air into water, exact (Born and Wolf).
fn fresnel_water(cos_incident: f32) -> f32 {
    let c = clamp(cos_incident, 0.0, 1.0);
    let g = sqrt(WATER_INDEX * WATER_INDEX - 1.0 + c * c);
    let a = (g - c) / (g + c);
    let b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return 0.5 * a * a * (1.0 + b * b);
}

// Mean reflectance of a rough sea of slope variance sigma2 (E. Bruneton, F. Neyret, N. Holzschuch 2010, eq. 15 with R0 = 0.02).
fn mean_fresnel(cos_view: f32, sigma2: f32) -> f32 {
    let sigma = sqrt(sigma2);
    let smooth_part = fresnel_water(cos_view);
    let rough = 0.02 + 0.98 * pow(1.0 - cos_view, 5.0 * exp(-2.69 * sigma)) / (1.0 + 22.7 * pow(sigma, 1.5));
    return mix(smooth_part, rough, smoothstep(0.0, 0.02, sigma2));
}

// Radiance of the sun's glitter per unit solar irradiance, for Gaussian slopes about `normal` of variance rough.x along the
// unit vector `along` and rough.y across it (C. Cox and W. Munk 1954; eq. 13 of the paper above).
fn glitter(view: vec3f, sun: vec3f, normal: vec3f, up: vec3f, along: vec3f, rough: vec2f) -> f32 {
    let sum = view + sun;
    let half_vector = sum / max(length(sum), 1e-6);
    let hz = max(dot(half_vector, up), 1e-3);
    let slope_h = (half_vector - hz * up) / hz;
    let nz = max(dot(normal, up), 1e-3);
    let slope_n = (normal - nz * up) / nz;
    let d = slope_h - slope_n;
    let variance = max(rough, vec2f(1e-5));        // the sun's own disc: (0.27 deg / 2)^2 on each axis
    let d_along = dot(d, along);
    let d_across = max(dot(d, d) - d_along * d_along, 0.0);
    let density = exp(-0.5 * (d_along * d_along / variance.x + d_across / variance.y))
        / (6.283185307179586 * sqrt(variance.x * variance.y));
    let cos_view = max(dot(view, up), 0.02);
    let shadow = smoothstep(-0.02, 0.05, dot(sun, up));
    return shadow * fresnel_water(dot(half_vector, view)) * density / (4.0 * hz * hz * hz * hz * cos_view);
}
