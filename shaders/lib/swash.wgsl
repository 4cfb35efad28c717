// Swash: the sheets of water that waves send up a beach, and the sand that they leave wet. As src/model/swash.rs, in 32 bits: see there what
// they are. The last crests are found anew in every pixel from the trains as they come to the waterline before it.
// Long, but one thing: from the height of the run-up to the crests, and from them to what they leave on the sand.
#import shore_trains
#import bed_cover

// R of all waves and what a wave adds that is as high as the significant height, of a sea `high` m high in deep water.
fn run_up(high: Metres, omega: f32, beta: f32) -> vec2f {
    // Between vertices without waves pixels whose middle lies beside their triangle have less than none.
    let height = max(high, 0.0);
    let length = WHOLE_TURN * GRAVITY / (omega * omega);
    let root = sqrt(height * length);
    let setup = 1.1 * 0.35 * beta * root;
    let swash = 1.1 * 0.5 / SWASH_FIFTIETH * root * sqrt(0.563 * beta * beta + 0.004);
    let steep = smoothstep(SWASH_FLAT, SWASH_NOT_FLAT, beta * inverseSqrt(max(height / length, 1e-9)));
    let whole = max(setup + SWASH_FIFTIETH * swash, 1e-9);
    return vec2f(setup, swash) * mix(SWASH_FLAT_RUNUP * root / whole, 1.0, steep);
}

// Of a beach whose ground rises by `face`.
fn foreshore(face: f32) -> f32 { return min(face, SWASH_STEEPEST); }

// How far up a beach of slope `beta` a fiftieth of the waves come.
fn run_up_reach(height: Metres, beta: f32) -> Metres {
    let rises = run_up(height, mean_omega(), beta);
    return (rises.x + SWASH_FIFTIETH * rises.y) / beta;
}

// u₀ and gβ.
struct Sheet { speed: f32, slows: f32 }

fn sheet_of(rises: Metres, beta: f32) -> Sheet { return Sheet(sqrt(2.0 * GRAVITY * max(rises, 0.0)), GRAVITY * beta); }

fn front_of(s: Sheet, t: f32) -> Metres { return t * (s.speed - 0.5 * s.slows * t); }

fn film_of(s: Sheet, x: Metres, t: f32) -> Metres {
    let over = max(front_of(s, t) - x, 0.0) / max(3.0 * t, 1e-3);
    return over * over / GRAVITY;
}

// For how long a place has been left by its water; below 0 where that is to come, and where the sheet does not come.
fn left_for(s: Sheet, x: Metres, t: f32) -> f32 {
    let below = s.speed * s.speed - 2.0 * s.slows * x;
    return select(-1.0, t - (s.speed + sqrt(max(below, 0.0))) / s.slows, below > 0.0);
}

// Frequency of a train that comes to a place, and its amplitude times the cosine and sine of its phase.
alias Arriving = array<vec3f, SHORE_TRAINS>;

// The trains as they come to a place on the waterline, and how much of the windows' energy has been found there.
fn arriving_at(point: MapPoint, nothing: bool, trains: ptr<function, Arriving>) -> f32 {
    let place = among_windows(point);
    let is_alone = !any(place.beyond > vec2f(0.0)) | nothing;
    var found = 0.0;
    var t = 0u;
    loop {
        let about = bitcast<vec2f>(shore_words[1u + 2u * t]);
        let now = bitcast<f32>(shore_words[2u + 2u * t].x);
        var wave = vec2f(0.0);
        var energy = 0.0;
        found = 0.0;
        var k = 0u;
        loop {
            let own = in_window(place, k, t);
            let turns = (now - own.rest) / WHOLE_TURN + own.chance;
            let turn = sine_cosine(WHOLE_TURN * (turns - floor(turns) - 0.5));
            let size = length(own.way);
            wave -= sqrt(own.energy) * size * vec2f(turn.cosine, turn.sine);
            energy += own.energy * size * size;
            found += own.energy;
            k++;
            if (k == 4u) | is_alone { break; }
        }
        (*trains)[t] = vec3f(about.x, about.y * sqrt(energy) / max(length(wave), 1e-6) * wave);
        t++;
        if (t == SHORE_TRAINS) | nothing { break; }
    }
    return found;
}

// Ages of the last crests of the trains' sum, s, the youngest first, and their heights, m; 0 of those that are not found.
struct Crests { ages: vec4f, heights: vec4f }

// Size and phase of the trains' sum, which then go back by their `turns`. Ends after the first where there is `nothing` to find.
fn arriving_sum(trains: ptr<function, Arriving>, turns: ptr<function, Arriving>, nothing: bool) -> vec2f {
    var z = vec2f(0.0);
    var t = 0u;
    loop {
        let train = (*trains)[t];
        let turn = (*turns)[t];
        z += train.yz;
        (*trains)[t] = vec3f(train.x, train.y * turn.y + train.z * turn.z, train.z * turn.y - train.y * turn.z);
        t++;
        if (t == SHORE_TRAINS) | nothing { break; }
    }
    return vec2f(length(z), angle_of(z.y, z.x));
}

fn last_crests(trains: ptr<function, Arriving>, mean: f32, nothing: bool) -> Crests {
    let quarter = 0.25 * WHOLE_TURN / mean;
    var turns: Arriving;
    var t = 0u;
    loop {
        let turn = sine_cosine((*trains)[t].x * quarter);
        turns[t] = vec3f(0.0, turn.cosine, turn.sine);
        t++;
        if (t == SHORE_TRAINS) | nothing { break; }
    }
    var found = Crests(vec4f(1e6), vec4f(0.0));
    var count = 0u;
    var after = arriving_sum(trains, &turns, nothing);
    var step = 1u;
    loop {
        let before = arriving_sum(trains, &turns, nothing);
        let turned = after.y - before.y;
        let is_crest = (after.y >= 0.0) & (before.y < 0.0) & (turned < 0.5 * WHOLE_TURN) & (count < SWASH_CRESTS);
        let part = after.y / max(turned, 1e-6);
        let at = vec4u(0u, 1u, 2u, 3u) == vec4u(select(4u, count, is_crest));
        found.ages = select(found.ages, vec4f((f32(step) - 1.0 + part) * quarter), at);
        found.heights = select(found.heights, vec4f(2.0 * mix(after.x, before.x, part)), at);
        count += select(0u, 1u, is_crest);
        after = before;
        step++;
        if (step > SWASH_STEPS) | nothing { break; }
    }
    return found;
}

// What swash makes of a place on a beach: how deep its water is, how far a pixel is under it, share of that under foam, how much of the sand
// shines, and is dark, and is dry all through, and lies under what floods have left, and how far the water has run since it came.
struct Swash { film: Metres, covered: f32, foam: f32, shines: f32, damp: f32, dry: f32, wrack: f32, run: Metres }

const SWASH_WIDEST: Metres = 60.0;         // no sheet comes so far; ours
const TONGUES = 0.91;               // of a run-up, in the mean: as tongues vary, a fiftieth of the waves come then as far as without; ours
const SWASH_SOAKED = 0.3;             // of the reach of the fiftieth, to where sand shines at all times; ours
const DRY_FROM = 3.5;                 // of the reach of the fiftieth, from where sand is dry all through; ours
const LULL = vec2f(0.02, 0.06);      // run-up of the fiftieth, m, below which there is none, and from which it is whole

// `line`: the place on the waterline below the place, which is `x` m up the beach; `height`: of the waves that come in; `beta`: its slope; `sees`: what is no
// wider does not show; `width`: how wide a pixel is up the beach.
fn swash_at(line: MapPoint, place: vec2f, x: Metres, height: Metres, beta: f32, sees: Metres, width: Metres) -> Swash {
    let has_trains = bitcast<vec2f>(shore_words[0]).y > 1.0;
    let omega = mean_omega();
    let rises = run_up(height, omega, beta);
    let fiftieth = rises.x + SWASH_FIFTIETH * rises.y;
    let farthest = fiftieth / beta;
    let nothing = (x < 0.0) | (x > min(1.8 * farthest, SWASH_WIDEST)) | (fiftieth < LULL.x);
    let is_on = select(1.0, 0.0, nothing) * smoothstep(LULL.x, LULL.y, fiftieth);
    var trains: Arriving;
    let found = arriving_at(line, nothing | !has_trains, &trains);
    let near = select(0.0, min(found, 1.0), has_trains) * (1.0 - smoothstep(0.25, 0.7, sees / max(farthest, 0.1)));

    // Tongues: along the shore waves run up differently far, other ones with each wave.
    let line_place = pattern_place(line, vec2f(0.0));
    let now = f32(frame.clock) / 1048576.0;
    let blur = max(0.7 * width, 0.02);
    let small = shown(sees, 0.5) * bed_noise(place, 0.5, 63u).z;
    let ragged = x + 0.9 * shown(sees, 2.0) * bed_noise(place, 2.0, 62u).z + 0.35 * small;
    let crests = last_crests(&trains, omega, nothing);
    var sheet = Swash(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    var k = 0u;
    loop {
        let age = crests.ages[k];
        let came = line_place + vec2f(5.0, 3.0) * (now - age);
        let broad = bed_noise(came, 32.0, 64u).z;
        let tongue = clamp(1.0 + 0.8 * broad + 0.9 * bed_noise(came, 16.0, 65u).z + 0.5 * bed_noise(came, 4.0, 66u).z, 0.35, 1.6);
        let relative = min(crests.heights[k] / max(height, 1e-3), 2.0);
        let s = sheet_of(TONGUES * tongue * (rises.x + relative * rises.y), beta);
        let t = age + 0.8 * broad;
        // Where nothing comes in they are none: they divide.
        let reach = max(0.5 * s.speed * s.speed / s.slows, 1e-3);
        let flight = max(2.0 * s.speed / s.slows, 1e-3);
        let behind = front_of(s, t) - ragged;
        // The oldest goes by and by.
        let lasts = select(0.0, 1.0 - smoothstep(3.0, 3.8, age * omega / WHOLE_TURN), t > 0.0);
        let covered = lasts * smoothstep(-blur, blur, behind);
        let ebbs = smoothstep(0.35, 0.75, t / flight);
        // The front carries a roll of foam up and leaves shreds behind; where it turns it leaves a line.
        let roll = 0.95 * exp(-max(behind, 0.0) / (0.45 + 0.05 * reach)) * (1.0 - 0.75 * ebbs);
        let shreds = 0.26 * exp(-max(behind, 0.0) / (0.35 * reach)) * exp(-max(t, 0.0) / (0.6 * flight));
        // In the water that they came from it is the sea's.
        let foam = covered * max(roll, shreds) * smoothstep(-1.0, 2.5, ragged);
        let left = left_for(s, ragged, t);
        let line_left = 0.3 * exp(-abs(ragged - 0.97 * reach) / (0.12 + blur)) * exp(-max(t - 0.5 * flight, 0.0) / 4.0)
            * step_up(t - 0.5 * flight);
        sheet.film = max(sheet.film, lasts * film_of(s, ragged, t));
        sheet.run = select(sheet.run, front_of(s, t), (behind > 0.0) & (covered > sheet.covered));
        sheet.covered = max(sheet.covered, covered);
        sheet.foam = max(sheet.foam, max(foam, lasts * line_left));
        sheet.shines = max(sheet.shines, max(covered, select(0.0, lasts * exp(-left / SWASH_SHINES), left > 0.0) * smoothstep(-blur, blur, reach - ragged)));
        k++;
        if (k == SWASH_CRESTS) | nothing { break; }
    }
    // By the waterline sand is never without water.
    let soaked = 1.0 - smoothstep(0.0, SWASH_SOAKED, ragged / max(farthest, 1e-3) + 0.12 * shown(sees, 4.0) * bed_noise(place, 4.0, 92u).z);
    sheet.shines = max(sheet.shines, soaked);
    // Sand that waves have reached within the last minutes is dark.
    // Cusps: horns and bays some 30 m apart, and how they differ along 100 m. They are one from the water to the dry sand.
    let longer = shown(sees, 128.0) * bed_noise(line_place, 128.0, 68u).z;
    let cusps = shown(sees, 32.0) * bed_noise(line_place, 32.0, 67u).z + 0.8 * longer;
    let mottled = shown(sees, 8.0) * bed_noise(place, 8.0, 89u).z + 0.6 * shown(sees, 2.0) * bed_noise(place, 2.0, 68u).z;
    let uneven = 1.0 + 0.5 * shown(sees, 16.0) * bed_noise(place, 16.0, 67u).z + 0.12 * shown(sees, 2.0) * bed_noise(place, 2.0, 68u).z;
    let band = x / max(farthest * uneven, 1e-3);
    let wider = 0.5 * blur / max(farthest, 0.1);
    // Where the band is a few pixels wide it would be a drawn line: what tides and rills make of it is seen as a gradient, faint here and dark there.
    let from_afar = smoothstep(0.15, 0.6, sees / max(farthest, 0.1));
    let sharp = 1.0 - smoothstep(0.65 - wider, 1.15 + wider, band + 0.1 * small);
    let damp = mix(sharp, clamp(0.45 + 1.6 * longer, 0.1, 0.9) * exp(-0.9 * max(band, 0.0)), from_afar);
    let dry = smoothstep(0.8, DRY_FROM, band + 1.2 * mottled);
    // Weed and shells lie where the highest waves have turned, in heaps and with gaps.
    let heaped = bed_noise(place, 8.0, 69u).z * shown(sees, 8.0) + bed_noise(place, 0.5, 70u).z * shown(sees, 0.5) + 0.7 * bed_noise(place, 0.125, 71u).z * shown(sees, 0.125);
    let from_line = (band - vec3f(1.25, 1.9 + 0.4 * cusps, 2.8 + 0.8 * cusps)) * farthest / (vec3f(0.5, 0.35, 0.6) + width);
    let wrack = dot(exp(-from_line * from_line), vec3f(1.0, 0.6, 0.4)) * smoothstep(0.25, 0.85, heaped) / (1.0 + width);
    // Where single waves do not show: what they are in the mean.
    let less = saturate(1.0 - band);
    let mean = Swash(0.02 * less, less * less, 0.45 * less * less, less, damp, dry, wrack, 0.0);
    let ashore = select(smoothstep(LULL.x, LULL.y, fiftieth), 0.0, x < 0.0);
    return Swash(is_on * mix(mean.film, sheet.film, near), is_on * mix(mean.covered, sheet.covered, near), is_on * mix(mean.foam, sheet.foam, near),
        is_on * mix(mean.shines, sheet.shines, near), ashore * max(damp, (1.0 - from_afar) * near * sheet.shines), mix(1.0, dry, ashore), ashore * wrack, near * sheet.run);
}

fn step_up(x: f32) -> f32 { return smoothstep(0.0, 0.6, x); }
