// Where the water's vertices are, of either mesh: on the ellipsoid, or as far over it as a lake, moved by the waves along its normal. Who
// imports this declares `MEASURED`, `UNDER_WATER`, `FINE`, `WAVES`, `SURF` and `LAKE`, as sea_pixel.wgsl does, and `ROLLERS`: whether these stand on the water.
#import projected_grid
#import bisected_mesh
#import world
#import waves
#import held
#import shore_trains
#import rollers

const LIFT_PIXELS = 2.0;           // half a pixel, and the chords of edges some pixels long
const STEP_BEYOND: Metres = 2.0;

// Depth of a lake, which no data tell, as far as waves feel it. Of rivers there is none.
fn depth_in_lake(ground: Ground) -> Metres { return select(max(LAKE_BED * ground.lake_shore, 0.0), 0.0, ground.by_river); }

// By which patches and the far sea's noise are mixed: on lakes there are the patches alone.
fn mixed_by(distance: Metres) -> Metres { return select(distance, 0.0, LAKE); }

// A vertex before and after the waves have moved it: as far as the depth allows, in a mesh whose vertices are so far apart.
// `sea` is what the trains of a shore leave of the waves there, `rise` what they and a roller add; `is_ocean` is asked where there are waves.
struct Place { rest: vec3f, moved: vec3f, height: Metres, allowed: f32, spacing: Metres, sea: LocalSea, rise: Metres, is_ocean: bool }

fn placed(rest: vec3f, spacing: Metres) -> Place {
    let up = normal_delta(rest) + vec3f(0.0, 0.0, 1.0);
    let distance = length(rest);
    var moved = vec3f(0.0);
    var allowed = 0.0;
    var sea = OPEN_SEA;
    var rise = 0.0;
    var is_ocean = false;
    if (frame.wave_height > 0.0) & !waves_are_pixels(distance) {
        let point = map_point(up - vec3f(0.0, 0.0, 1.0));
        sea = local_water(point, select(OF_OCEAN, OF_LAKE, LAKE));
        let ground = ground_at(point, frame.sin_lat + sin_lat_delta(up - vec3f(0.0, 0.0, 1.0)), max(spacing, 20.0));
        is_ocean = ground.is_ocean;
        if !LAKE { sea = behind_reefs(sea, ground.waves); }
        if SURF {
            let waves = shore_waves_at(point, -ground.elevation, -ground.plain, ground.waves, ground.ocean_shore, ground.face, distance, spacing, 0.0);
            sea = left_by_trains(sea, waves.share);
            rise = waves.rise;
        }
        allowed = held_share(select(-ground.elevation, depth_in_lake(ground), LAKE), sea.height);
        moved = vec3f(0.0, 0.0, rise) + allowed * displacement_in(sea, rest, mixed_by(distance), spacing);
        if ROLLERS {
            let roller = roller_at(rest, length(rest + moved.z * up), spacing, moved.z, sea.height, allowed * sea.height);
            rise += roller;
            moved.z += roller;
        }
    }
    return Place(rest, rest + moved.x * vec3f(1.0, 0.0, 0.0) + moved.y * vec3f(0.0, 1.0, 0.0) + moved.z * up, moved.z, allowed, spacing, sea, rise, is_ocean);
}

// The water a step beyond a place, as the eye sees it: level way, and how much higher. What `crest_light` takes.
fn beyond(place: Place) -> vec2f {
    if !WAVES || !FINE || MEASURED || UNDER_WATER { return vec2f(STEP_BEYOND, 0.0); }
    let level = vec3f(normalize(place.rest.xy + vec2f(1e-6, 0.0)), 0.0);
    let rest = place.rest + STEP_BEYOND * level;
    // The trains of a shore are too long to differ here, and rollers let no light through.
    let there = vec3f(0.0, 0.0, place.rise) + place.allowed * displacement_in(place.sea, rest, mixed_by(length(rest)), place.spacing);
    let here = place.moved - place.rest;
    return vec2f(max(STEP_BEYOND + dot(there - here, level), 0.2 * STEP_BEYOND), there.z - place.height);
}

fn place_on_grid(grid: vec2f) -> Place {
    let rest = rest_position(grid);
    let distance = length(rest);
    let up = normal_delta(rest) + vec3f(0.0, 0.0, 1.0);
    let spacing = distance * frame.pixel_angle * frame.cell_pixels / sqrt(max(abs(dot(rest, up)) / max(distance, 1e-3), 0.03));
    return placed(rest, spacing);
}

// The bisected mesh ends at the limb, and its chords before: beyond the waves it is lifted by pixels, and the fragments' own rays decide.
fn lifted(place: Place) -> Place {
    let distance = length(place.rest);
    let share = smoothstep(1.0, 2.0, distance * frame.pixel_angle / (4.0 * frame.crest_height));
    if (share <= 0.0) | UNDER_WATER { return place; }
    let up = normal_delta(place.rest) + vec3f(0.0, 0.0, 1.0);
    var higher = place;
    higher.moved += LIFT_PIXELS * share * distance * frame.pixel_angle * up;
    return higher;
}

// A corner that halves an edge begins in the edge's middle and takes its own place while the edge grows on the screen.
fn place_of_bisection(index: u32) -> Place {
    let corner = drawn_corner(index);
    let rest = rest_of(corner);
    let own = placed(rest, wished_length(rest));
    let edge = parents(corner);
    if !edge.exists { return lifted(own); }
    let grown = grown_share(edge);
    if grown >= 1.0 { return lifted(own); }
    let first = rest_of(edge.first);
    let second = rest_of(edge.second);
    let a = placed(first, wished_length(first));
    let b = placed(second, wished_length(second));
    var between = own;
    between.rest = mix(0.5 * (a.rest + b.rest), own.rest, grown);
    between.moved = mix(0.5 * (a.moved + b.moved), own.moved, grown);
    between.height = mix(0.5 * (a.height + b.height), own.height, grown);
    return lifted(between);
}
