// How much of the sun's light comes through the air. Who imports this declares `transmittances`, the table that air_table.wgsl makes.
#import atmosphere

// Share of a beam from space that reaches height h, 0…TOP, from the zenith cosine mu; below the horizon that of the horizon.
fn transmittance(h: Metres, mu: f32) -> vec3f {
    let place = table_place(transmittance_coordinates(h, mu), textureDimensions(transmittances));
    return textureSampleLevel(transmittances, clamped, place, 0.0).rgb;
}

// Share of sunlight that reaches height h with the sun at zenith cosine mu; the earth's shadow has a soft edge.
fn sunlight(h: Metres, mu: f32) -> vec3f {
    let r = frame.semi_major + h;
    let horizon = -sqrt(h * (r + frame.semi_major)) / r;
    let visible = smoothstep(-0.006, 0.006, mu - horizon);
    if visible <= 0.0 { return vec3f(0.0); }
    return visible * transmittance(min(h, TOP), max(mu, horizon));
}
