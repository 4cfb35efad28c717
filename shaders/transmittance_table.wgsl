// The transmittance of the air towards its top, for any eye and sun. Air mass: C. Schueler 2012, "An approximation to the Chapman
// grazing-incidence function".
#import atmosphere

@group(1) @binding(0) var transmittance_table: texture_storage_2d<rgba16float, write>;

// Column seen towards zenith cosine mu from height h, in units of the vertical column at h.
fn air_mass(h: Metres, mu: f32, scale: Metres) -> f32 {
    let x = (frame.semi_major + h) / scale;
    let c = sqrt(0.5 * PI * x);
    if mu >= 0.0 { return c / ((c - 1.0) * mu + 1.0); }
    let sin2 = max(1.0 - mu * mu, 0.0);
    let x0 = sqrt(sin2) * x;                              // at the ray's lowest point
    let c0 = sqrt(0.5 * PI * x0);
    return min(2.0 * c0 * exp(min(x - x0, 60.0)) - c / ((c - 1.0) * -mu + 1.0), 1e6);
}

@compute @workgroup_size(8, 8)
fn transmittances(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(transmittance_table);
    if any(id.xy >= size) { return; }
    let view = transmittance_view(vec2f(id.xy) / vec2f(size - 1u));
    let h = view.x;
    let mu = view.y;
    let r = frame.semi_major + h;
    let rayleigh = RAYLEIGH_HEIGHT * exp(-h / RAYLEIGH_HEIGHT) * air_mass(h, mu, RAYLEIGH_HEIGHT);
    let mie = MIE_HEIGHT * exp(-h / MIE_HEIGHT) * air_mass(h, mu, MIE_HEIGHT);
    let ratio = min(r / (frame.semi_major + OZONE_HEIGHT), 1.0);
    let ozone = OZONE_THICKNESS / sqrt(max(1.0 - ratio * ratio * (1.0 - mu * mu), 0.002))
        * select(1.0, 0.0, h > OZONE_HEIGHT && mu > 0.0);
    let value = exp(-(RAYLEIGH * rayleigh + mie_extinction() * mie + OZONE * ozone));
    textureStore(transmittance_table, id.xy, vec4f(value, 1.0));
}
