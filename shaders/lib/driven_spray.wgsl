// What the wind does to the spray of storms over open water: it drives it in gusts and in sheets along the wind.
#import lace

// The level of two nets, of turns and texels as given, which are blown so many times their sides
// while the wave clock's 32 bits turn: 20 m/s. The sheets' are turned by 7 degrees, as levels of one tile that lie in step are not independent. Part of
// the level's variance that they have, and deviation of the logarithm of how dense spray is.
const GUSTS = vec2i(8192, 2048);
const GUSTS_BLOWN = vec2u(40u, 0u);
const SHEETS_TURN = vec2i(8, 1);
const SHEETS = vec2i(16384, 4096);
const SHEETS_BLOWN = vec2u(160u, 80u);
const IN_SHEETS = 0.35;
const GUSTINESS = 0.7;
// Close to the water there is a sheet of it so deep, were it as dense as the rest.
const SHEET: Metres = 3.5;
const DRIVEN_FROM: Metres = 150.0;     // of a shore, where land's pixels, which know of no gusts, are next to the sea's

// Of a number of turns of the wave clock's, how far the last has come.
fn clock_turns(times: vec2u) -> vec2f { return vec2f(frame.clock * times) / 4294967296.0; }

// How dense spray is before a place of the foam map's plane, of the usual, and the optical depth of the sheet on the water. `pixel`: as `lace_in` has it.
fn driven_spray(at: vec2f, pixel: vec2f, grazing: f32, distance: Metres, from_shore: Metres) -> vec2f {
    let texels = lace_texels(at);
    let level = both(net_blown(vec2i(1, 0), GUSTS, texels, pixel, clock_turns(GUSTS_BLOWN)),
        net_blown(SHEETS_TURN, SHEETS, texels, pixel, clock_turns(SHEETS_BLOWN)), IN_SHEETS);
    // Below storms it is too thin to be torn.
    let driven = storm() * smoothstep(0.0, DRIVEN_FROM, from_shore);
    let deviation = GUSTINESS * driven;
    let gust = exp(deviation * level.level - 0.5 * deviation * deviation * level.kept);
    return vec2f(gust, frame.spray * driven * gust * min(SHEET / max(grazing, 0.02), distance));
}

// How much denser than usual the sheet on the water is where that is so many deviations high, of which pixels show `kept`: the mean over a sea is 1. Crests shelter
// the troughs behind them from the spray that is torn off.
const SHEET_ON_CRESTS: f32 = 0.7;
const SPRAY_ON_CRESTS: f32 = 0.3;

fn spray_on_crests(driven: vec2f, deviations: f32, kept: f32) -> vec2f {
    let contrast = vec2f(SPRAY_ON_CRESTS, SHEET_ON_CRESTS) * kept * storm();
    return driven * exp(contrast * clamp(deviations, -3.0, 3.0) - 0.5 * contrast * contrast);
}
