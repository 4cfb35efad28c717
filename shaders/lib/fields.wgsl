// Farmland: fields side by side, as wide as farmers plough, some with hedges between.
#import frame
#import noise

const FIELD_TURN = vec2u(3u, 2u); // how their rows lie on the map before they are bent,
const FIELD_CELL: Metres = 169.6; // and how wide they are at the equator: 2^16 units of the map over that vector's length
const FIELDS_BENT = 0.06;         // how far their rows are bent by what is 4.9 km wide, of its cells a rise
const HEDGE = 0.035;              // half of a hedge's width, of a row's
const FARMED_TO = vec2f(3250.0, 3460.0); // how high farms are found at the equator, m, and how much less so at a pole: 1,600 m at 43.5 degrees
const TILLED = vec2f(-0.14, 0.04); // of `tillage`, from woods and heaths to farms,
const USUAL_TILLAGE = -0.043;     // and where it is so much as it is in the mean
const HEDGED = 0.5;               // share of borders that have one
const BORDERS = 1.625;            // borders beside a cell, of two that it could have: see `column_of`
// What a bright field has more, and a ripe one of red, green and blue, and a hedge less, of the ground's mean.
const FIELD_TONE = 0.30;
const FIELD_HUE = vec3f(0.15, 0.02, -0.03);
const HEDGE_TONE = 0.45;

// `tone` and `ripe` from -1 to 1, and `hedge`, the share that hedges cover; the mean of each is none.
struct Fields { tone: f32, ripe: f32, hedge: f32 }

fn field_tones(fields: Fields) -> vec3f { return FIELD_TONE * fields.tone + FIELD_HUE * fields.ripe - HEDGE_TONE * fields.hedge; }

// How far ground is farmed: level, neither a dark forest nor a desert, not too far north or south nor too high, and more of it here than there: woods and
// heaths are left where `tillage` is low, in patches as wide as 5 and 1 km.
fn farmed(albedo: vec3f, green: f32, slope: f32, elevation: Metres, sin_lat: f32, tillage: f32) -> f32 {
    let highest = max(FARMED_TO.x - FARMED_TO.y * sin_lat * sin_lat, 200.0);
    let suits = smoothstep(0.05, 0.08, albedo.g) * smoothstep(0.3, 0.6, green) * smoothstep(0.12, 0.05, slope) * smoothstep(0.90, 0.86, abs(sin_lat));
    return suits * smoothstep(1.1 * highest, 0.9 * highest, elevation) * smoothstep(TILLED.x, TILLED.y, tillage);
}

// Which field of its row a cell is part of: one cell, two or, a quarter of them, four are tilled as one. 0.625 of the borders between cells are left.
fn column_of(cell: vec2u) -> u32 {
    let word = hash(vec3u(cell.x >> 2u, cell.y, 91u));
    let paired = ((word >> (16u + ((cell.x >> 1u) & 1u))) & 1u) == 1u;
    return select(select(cell.x, (cell.x >> 1u) | 0x40000000u, paired), (cell.x >> 2u) | 0x80000000u, (word >> 30u) == 0u);
}

fn field_of(column: u32, row: u32) -> vec2f {
    let word = hash(vec3u(column, row, 92u));
    return vec2f(vec2u(word & 0xffffu, word >> 16u)) / 32767.5 - 1.0;
}

fn is_hedged(first: u32, second: u32, row: u32) -> bool {
    return first != second && f32(hash(vec3u(max(first, second), row, 93u)) >> 16u) < HEDGED * 65536.0;
}

// What a pixel shows of them; `bend`: the rise of the noise that bends their rows, of cells of 2^19 units.
fn fields_at(at: vec2u, bend: vec2f, footprint: Metres) -> Fields {
    let moved = at + bitcast<vec2u>(vec2i(FIELDS_BENT * bend * 524288.0));
    let turned = vec2u(FIELD_TURN.x * moved.x + FIELD_TURN.y * moved.y, FIELD_TURN.x * moved.y - FIELD_TURN.y * moved.x);
    let size = max(footprint / (FIELD_CELL * max(frame.cos_lat, 0.1)), 0.01);
    let part = vec2f(turned & vec2u(0xffffu)) / 65536.0;
    let cell = turned >> vec2u(16u);
    let other = cell + select(vec2u(0xffffffffu), vec2u(1u), part >= vec2f(0.5));
    let column = column_of(cell);
    let beside = column_of(vec2u(other.x, cell.y));
    // Half of a pixel may lie across a border.
    let border = min(part, 1.0 - part);
    let beyond = saturate(0.5 - border / size);
    let here = mix(field_of(column, cell.y), field_of(beside, cell.y), beyond.x);
    let there = mix(field_of(column_of(vec2u(cell.x, other.y)), other.y), field_of(column_of(other), other.y), beyond.x);
    let field = mix(here, there, beyond.y);
    let covered = saturate((HEDGE - border) / size + 0.5) * min(2.0 * HEDGE / size, 1.0);
    let hedge = max(select(0.0, covered.x, is_hedged(column, beside, cell.y)), select(0.0, covered.y, is_hedged(cell.y, other.y, 0u)));
    let shown = 1.0 - smoothstep(0.3, 0.9, size);
    return Fields(shown * field.x, shown * field.y, shown * (hedge - 2.0 * HEDGE * HEDGED * BORDERS));
}
