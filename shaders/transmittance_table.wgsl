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

// Column of ozone towards zenith cosine mu from height h: that of the layer's middle, crossed at the slope that the ray has there. A ray that goes down
// before it goes up crosses the layer on both sides of its lowest point; one that only touches it has the chord of a tent.
fn ozone_column(h: Metres, mu: f32) -> Metres {
    let r = frame.semi_major + h;
    let lowest = r * sqrt(max(1.0 - mu * mu, 0.0)) - frame.semi_major;
    let sine2 = 2.0 * (OZONE_HEIGHT - lowest) / (frame.semi_major + OZONE_HEIGHT);
    let crossed = OZONE_THICKNESS / sqrt(max(max(sine2, select(mu * mu, 0.0, mu < 0.0)), OZONE_TANGENT));
    let off = (h - OZONE_HEIGHT) / OZONE_THICKNESS;
    let far = 0.5 * (1.0 - min(abs(off), 1.0)) * (1.0 - min(abs(off), 1.0));
    let above = select(1.0 - far, far, off > 0.0);
    let touched = saturate(1.0 - (lowest - OZONE_HEIGHT) / OZONE_THICKNESS);
    return crossed * select(above, 2.0 * touched * sqrt(touched) - above, mu < 0.0);
}

// Sine squared at which the layer's middle is crossed by a ray that touches it, were its column that of a plane: a half of the tent's chord,
// 2/3 sqrt(2 a OZONE_THICKNESS).
const OZONE_TANGENT = 0.00265;

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
    let value = exp(-(RAYLEIGH * rayleigh + mie_extinction() * mie + OZONE * ozone_column(h, mu)));
    textureStore(transmittance_table, id.xy, vec4f(value, 1.0));
}
