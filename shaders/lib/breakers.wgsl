// What becomes of waves where they feel the bottom: height, breaking and shape. As src/model/surf.rs, in 32 bits.
#import frame
#import trigonometry

const GRAVITY: f32 = 9.80665;
const WHOLE_TURN: f32 = 6.283185307179586;

// kh of waves whose ω²h/g is `u`: Eckart's start and a step of Newton's, within 0.2 %.
fn depth_number(u: f32) -> f32 {
    let x = u / sqrt(hyperbolic(u));
    let t = hyperbolic(x);
    return x - (x * t - u) / (t + x * (1.0 - t * t));
}

// tanh, where builtins may overflow.
fn hyperbolic(x: f32) -> f32 { return tanh(min(x, 15.0)); }

// Height over that in deep water, of waves with kh = `y`.
fn shoaling(y: f32) -> f32 {
    let twice = min(2.0 * y, 30.0);
    let group = 0.5 * (1.0 + twice / sinh(max(twice, 1e-3)));
    return inverseSqrt(2.0 * group * hyperbolic(y));
}

fn breaker_index(slope: f32, height: Metres, omega: f32) -> f32 {
    let steepness = height * omega * omega / (WHOLE_TURN * WHOLE_TURN * GRAVITY);
    return clamp(0.6 * (1.56 / (1.0 + exp(-19.5 * slope)) - 43.75 * (1.0 - exp(-19.0 * slope)) * steepness), BREAKER_LEAST_INDEX, 1.1);
}

fn breaking_depth(deep: Metres, k_deep: f32, gamma: f32) -> Metres {
    let shallow = pow(max(deep, 1e-6) / gamma, 0.8) * pow(4.0 * k_deep, -0.2);
    return shallow * (1.0 + 0.22 * k_deep * shallow);
}

// Iribarren's number of a wave that breaks so high.
fn similarity(slope: f32, height: Metres, omega: f32) -> f32 {
    return slope * sqrt(WHOLE_TURN * GRAVITY / (omega * omega * max(height, 1e-6)));
}

// How far a wave has become a bore where the depth is `over` that in which it breaks: one that spills by and by, one that plunges at once, one that surges never.
fn bore_in(over: f32, similar: f32) -> f32 {
    let plunges = smoothstep(BREAKER_PLUNGES, BREAKER_PLUNGING, similar);
    let surges = smoothstep(BREAKER_SURGES, BREAKER_SURGING, similar);
    return (1.0 - surges) * (1.0 - smoothstep(mix(BREAKER_BORE_LAST, BREAKER_BORE_PLUNGING, plunges), BREAKER_BORE_FIRST, over));
}

fn broken_height(over: f32, slope: f32, gamma: f32) -> f32 {
    let ratio = BREAKER_DECAY / slope;
    let at = select(ratio, 2.505, abs(ratio - 2.5) < 5e-3);
    let y = clamp(over, 1e-4, 1.0);
    let stable = BREAKER_STABLE / gamma;
    let alpha = at * stable * stable / (2.5 - at);
    return sqrt(max((1.0 + alpha) * pow(y, at - 0.5) - alpha * y * y, 0.0));
}

// r and φ of a wave's shape: as skewed as its Ursell number has it, as pointed as the chop does.
fn wave_shape(height: Metres, y: f32, depth: Metres, bore: f32, chop: f32) -> vec2f {
    let ursell = max(0.375 * height / depth / (y * y), 1e-6);
    let skew = 0.857 / (1.0 + exp((-0.471 - 0.4342945 * log(ursell)) / 0.297));
    let b = sqrt(2.0) * skew * inverseSqrt(9.0 + 2.0 * skew * skew);
    let phase = -0.25 * WHOLE_TURN * hyperbolic(0.815 * pow(ursell, -0.672));
    let pointed = 0.5 * chop * height * y / (depth * hyperbolic(y));
    return vec2f(mix(max(2.0 * b / (1.0 + b * b), min(pointed, BREAKER_BORE)), BREAKER_BORE, bore), phase * (1.0 - bore));
}

// The surface per half of the height, and its derivative by the phase, whose cosine and sine are those of `turn`.
fn wave_surface(shape: vec2f, turn: vec2f) -> vec2f {
    let f = sqrt(1.0 - shape.x * shape.x);
    let scale = sqrt(0.5 * f * (1.0 + f));
    let moved = sine_cosine(shape.y);
    let at = vec2f(turn.x * moved.cosine - turn.y * moved.sine, turn.y * moved.cosine + turn.x * moved.sine);
    let rise = turn.y + shape.x * moved.sine / (1.0 + f);
    let below = 1.0 - shape.x * at.x;
    return scale * vec2f(rise / below, (turn.x * below - rise * shape.x * at.y) / (below * below));
}
