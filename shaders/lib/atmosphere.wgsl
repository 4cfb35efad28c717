// The air: what it is made of, and the coordinates of the table of its transmittance. Coefficients of molecules: E. Bruneton and F. Neyret 2008,
// S. Hillaire 2020; the aerosol is that of the open sea: its optical depth falls with the wavelength to the power of 0.6 (A. Smirnov
// et al. 2009, "Maritime Aerosol Network"), and it scatters nearly all that it takes out of a beam.
#import ellipsoid

const RAYLEIGH = vec3f(5.802e-6, 13.558e-6, 33.1e-6);    // per metre at sea level
const MIE_COLOUR = vec3f(0.880, 1.0, 1.143);             // (wavelength / 550 nm)^-0.6 at 680, 550 and 440 nm
const MIE_ALBEDO = 0.98;
// What 300 Dobson units take of the sun's red, green and blue, not of 680, 550 and 440 nm as is often written: the Chappuis band is strongest at
// 600 nm, at which reds are seen, and with them limb and dusk are blue instead of purple. Spectra of the cross section at 233 K (V. Gorshelev et al. 2014).
const OZONE = vec3f(2.65e-6, 1.67e-6, 0.0);
const OZONE_THICKNESS: Metres = 15000.0;
const OZONE_HEIGHT: Metres = 25000.0;
const RAYLEIGH_HEIGHT: Metres = 8000.0;                  // scale heights
// Above the tropopause the air is thinner than the exponential: with these it scatters from 8 to 70 km within 6 % of what the US Standard
// Atmosphere 1976 does (its densities with the optical depth .0972 at 550 nm of B. Bodhaine et al. 1999), and all of the light of twilight comes
// from there. At sea level it scatters a sixth more, and its whole column is .103.
const THIN_ABOVE = 0.385;
const THINS_FROM: Metres = 4000.0;
const THINS_TO: Metres = 44000.0;
const MIE_HEIGHT: Metres = 1200.0;
const SUN_IRRADIANCE = vec3f(1.0, 0.98, 0.95);           // the unit of radiance; colour of the extraterrestrial sun
const PI = 3.141592653589793;

// Extinction by the aerosol at sea level, per metre: a column of `frame.haze` at 550 nm over its scale height.
fn mie_extinction() -> vec3f { return frame.haze / MIE_HEIGHT * MIE_COLOUR; }

fn thinned(h: Metres) -> f32 { return mix(1.0, THIN_ABOVE, smoothstep(THINS_FROM, THINS_TO, h)); }

// The air at a height: what molecules and aerosol scatter, and what a beam loses, per metre.
struct Medium { rayleigh: vec3f, mie: vec3f, extinction: vec3f }

fn medium_at(h: Metres) -> Medium {
    let rayleigh = RAYLEIGH * exp(-h / RAYLEIGH_HEIGHT) * thinned(h);
    let mie = mie_extinction() * exp(-h / MIE_HEIGHT);
    let ozone = OZONE * max(1.0 - abs(h - OZONE_HEIGHT) / OZONE_THICKNESS, 0.0);
    return Medium(rayleigh, MIE_ALBEDO * mie, rayleigh + mie + ozone);
}

// Length of a step of which `extinction` leaves the share `passed`, as far as its far parts still count.
fn seen_length(extinction: vec3f, passed: vec3f) -> vec3f { return (vec3f(1.0) - passed) / max(extinction, vec3f(1e-12)); }

fn rayleigh_phase(c: f32) -> f32 { return 3.0 / (16.0 * PI) * (1.0 + c * c); }

// Cornette-Shanks, g = 0.75.
fn mie_phase(c: f32) -> f32 {
    let g = 0.75;
    let d = max(1.0 + g * g - 2.0 * g * c, 1e-4);
    return 3.0 / (8.0 * PI) * (1.0 - g * g) * (1.0 + c * c) / ((2.0 + g * g) * d * sqrt(d));
}

// A place in a table of `size` texels for coordinates 0…1, whose ends are the middles of the first and the last texel.
fn table_place(x: vec2f, size: vec2u) -> vec2f { return (x * vec2f(size - 1u) + 0.5) / vec2f(size); }

// Of the table of transmittance, for the zenith cosine mu at height h: x is how far the air's top is along the ray, between the
// zenith and the horizon; y how far the horizon is (E. Bruneton 2017, "Precomputed atmospheric scattering: a new implementation").
fn transmittance_coordinates(h: Metres, mu: f32) -> vec2f {
    let r = frame.semi_major + h;
    let level = sqrt(TOP * (2.0 * frame.semi_major + TOP));
    let horizon = sqrt(h * (2.0 * frame.semi_major + h));
    let nearest = TOP - h;
    let d = sqrt(max(r * r * mu * mu + nearest * (2.0 * frame.semi_major + TOP + h), 0.0)) - r * mu;
    return clamp(vec2f((d - nearest) / (horizon + level - nearest), horizon / level), vec2f(0.0), vec2f(1.0));
}

// Height and zenith cosine of those coordinates.
fn transmittance_view(x: vec2f) -> vec2f {
    let level = sqrt(TOP * (2.0 * frame.semi_major + TOP));
    let horizon = x.y * level;
    let r = sqrt(horizon * horizon + frame.semi_major * frame.semi_major);
    let h = horizon * horizon / (r + frame.semi_major);
    let d = mix(TOP - h, horizon + level, x.x);
    return vec2f(h, clamp((level * level - horizon * horizon - d * d) / (2.0 * r * d), -1.0, 1.0));
}
