// Dry land, lakes and the sea bed. Who imports this declares IMAGERY and FINE (src/pass/kind.rs), GROWTH, whether pixels may be so narrow that they show
// what grows on the ground and its grain, TOWN, whether there may be houses, SHOWS_COVER, whether they may be so narrow
// that they show what covers the bed, DETAIL, whether so narrow that they show anything of `ground_detail`, and BED_ALONE, whether all is a bed on which
// nothing of the land shows.
// Long, but one thing: the ground's colour and light at a place, from what lies there over what grows, is built and has been washed up to how it is lit.
#import ground_colour
#import bed_cover
#import houses
#import imagery
#import inland
#import plants
#import shore_kind
#import shore_pixels
#import walls
#import water

const BEACH: Metres = 50.0;     // how wide beaches are as a rule
const SAND = vec3f(0.36, 0.31, 0.22);
const ROCK = vec3f(0.13, 0.115, 0.10);
// Rocky coasts: bare rock and shingle, weeds and rock below the water, kelp where ice has scoured them, no beach but in coves.
const SHORE_ROCK = vec3f(0.105, 0.098, 0.086);
const ROCKY_BED = vec3f(0.095, 0.090, 0.066);
const SCOURED_BED = vec3f(0.055, 0.058, 0.042);
const BOULDERS = vec2f(1.8, 6.0);    // how much more their tones and their slopes differ than a beach's
const ROCKY_WIDTH = 0.33;        // of their bare shores, of a beach's
const COVES = vec3f(0.05, 0.78, 0.14);  // of a noise over 1.2 km, up to which shores are rock where they begin to be and where all are, and over how much they go over to a cove's
const KIND_SEEN = vec2f(100.0, 400.0);  // widths of pixels, m, between which shores are no longer told from each other
// Where no waves come: walls and stones, or mud below mangroves.
const BANK = vec3f(0.15, 0.145, 0.135);
const MUD = vec3f(0.085, 0.073, 0.052);
const BANK_WIDTH = 0.1;          // of a beach's
const QUAYS = vec2f(0.02, 0.25); // how far shores are such banks, between which towns go over from beaches to quays
const WAVE_CUT = vec3f(0.115, 0.108, 0.092); // rock at the foot of walls, wet and overgrown
const WOODED = 0.7;              // of what towers' tops and ledges reflect: forests grow there
const WALLED_WIDTH = 0.06;       // and below walls
const BANK_BED = vec3f(0.10, 0.092, 0.068);

const WIND_RIPPLES: Metres = 0.11;      // from crest to crest
const RIPPLED_ALONG = vec2f(0.857, 0.515);      // a way that they lie across
const STANDING = 0.8;            // share of a dome's slope that shades it: leaves are rough, and let light through
const BENT = 0.5;               // how far the lattices of what grows are bent, of the detail's bends: more would squeeze what stands there
const FRAYED = 0.55;             // how far what grows reaches out on to a beach and leaves gaps, of the beach's width, a tone
const SAND_MOTTLES = vec4f(0.25, 0.35, 0.25, 0.15);      // of patches some 76, 19, 5 and 1 m wide
const WET_SAND = 0.66;            // reflectance of wet sand over that of dry sand
const SHORE_SAND = vec2f(30.0, 80.0);   // from the shore, m, between which the sand of the bed loses its mottles and its grain
const GRAIN_TO: Metres = 0.6;     // depth to which its grain shows
const BED_AS_BEACH: Metres = 2.5; // depth to which the bed is the beach's sand, more and more the sea's own; the water over it wets it
const FARMED_FROM = vec2f(120.0, 400.0);   // how far from the ocean farms begin, m: none on cays and spits
const THROUGH_LEAVES = 0.35;      // light that comes through what grows, of that on level ground
const SPARSE_GRASS = 0.35;        // share of the ground that grass covers where it begins
const HOLDS_ON = 0.35;           // by how much steeper slopes have to be where forests of the wet tropics grow, before rock stands out
const HOLDS_ON_VALLEYS = 1.0;    // and in valleys that are as steep all over
const FIRS = vec2f(0.72, 0.85);    // sines of latitudes between which broad crowns become pointed ones
const CROWN_GAIN = 0.1;          // by which crowns that show are brighter than their sides and their shadows on each other would be, so that a wood is as bright from near as from afar
const OVERHUNG_WIDTH = 0.12;     // of a beach's, below woods where they hang over the water,
const OPEN_WIDTH = 1.3;          // and where they do not
const LAYERED = 0.5;             // how far layers of rock and the ledges between tell where a slope is bare
const OVERGROWN_ROCK = 0.7;      // of what rock reflects elsewhere, that of the wet tropics: plants hold on to it
const ROCK_LAYERS = 1.3;         // and how much their tones differ,
const ROCK_STREAKS = 0.7;        // and those of what has run down over them
const WOODS_ROUGH = 0.25;        // slopes of woods' tops over tens of metres
const HOT_SPOT = 0.45;           // how much of the light is lost to shadows that woods cast on themselves; none as satellites see
const HOT_SPOT_MEAN = 0.75;      // them, from above with a sun 30° from the zenith
const SNOW = vec3f(0.74, 0.76, 0.72);
const THAWED = vec3f(0.085, 0.095, 0.055);         // what lies below it
const SNOW_THAWS: Metres = 400.0;                  // it lies as where the relief tells from this height on
const ICY_COASTS = vec4f(-0.809, -0.719, 0.927, 0.951);      // sines of 54° and 46° south, of 68° and 72° north: coasts beyond have ice down to the sea
const NOT_WHITE = vec2f(0.6, 0.8);                 // of blue's albedo over red's
const SNOW_EDGE = 0.2;                             // how gradually it ends, of all heights
const SNOW_SEEN = vec2f(150.0, 700.0);             // widths of pixels between which the relief is no longer seen, metres
const HOLLOW = 0.6;              // of the sky's light, that the deepest valleys lack; ours

// How wide a pixel is on ground that is seen aslant.
fn ground_footprint(across: Metres, direction: vec3f, up: vec3f) -> Metres {
    return across / sqrt(max(abs(dot(direction, up)), 0.05));
}

// What a pixel shows of the ground, and where. `kind`: of its shore; pixels so wide show nothing of it may have none. `bed`: how far the bed is of that kind.
struct Place { distance: Metres, dn: vec3f, point: MapPoint, part: vec2f, sin_lat: f32, ground: Ground, kind: ShoreKind, bed: f32 }

// `sandy`: how much of a beach there may be, between cliffs and snow; none of a bed is one.
struct LitGround { normal: vec3f, albedo: vec3f, radiance: vec3f, sandy: f32 }

// How wide the beach is at a place: by a third to three times of what is usual, over some 100 m to 2 km.
fn beach_width(at: vec2u, usual: Metres) -> Metres {
    return usual * exp(3.0 * (map_noise_rise(at, 15u, 81u).x + map_noise_rise(at, 17u, 82u).x));
}

// How far a beach is overgrown at a distance from the ocean, of its width: never along a line, but in patches of all sizes.
fn overgrown(inland: f32, tone: f32, footprint: Metres) -> f32 {
    // Each octave that does not show of a tone widens the edge.
    let hidden = sqrt(clamp(0.5 * log2(footprint / 0.15), 0.0, 8.0));
    let edge = FRAYED * (0.3 + 0.25 * hidden);
    return smoothstep(-edge, edge, inland - 1.0 + FRAYED * tone);
}

// Of what is small on the ground: its tone, whose mean is none, and its slope east and north.
struct Grain { tone: f32, slope: vec2f }

// Heaps, hollows that feet and wind have left, and grains, from 4 m down to 1.6 cm. The loop ends at its foot.
fn grain_at(point: MapPoint, part: vec2f, footprint: Metres, rocky: f32) -> Grain {
    let place = pattern_place(point, part);
    var found = Grain(0.0, vec2f(0.0));
    var heaps = vec2f(0.0);
    var cell = 4.0;
    var salt = 73u;
    loop {
        let noise = shown(footprint, cell) * bed_noise(place, cell, salt);
        found.tone += 0.28 * noise.z;
        heaps = select(heaps, vec2f(noise.z, heaps.x), cell > 0.5);
        found.slope += 0.055 * cell * noise.xy;
        cell *= 0.25;
        salt++;
        if cell < 0.015 || footprint > 0.6 * cell { break; }
    }
    // Ripples that the wind has made, where it has: they fork where heaps bend them.
    let rippled = (1.0 - rocky) * shown(footprint, WIND_RIPPLES) * smoothstep(-0.1, 0.2, heaps.y + 0.3 * heaps.x);
    let along = TURN * fract((dot(place, RIPPLED_ALONG) + 0.12 * heaps.x + 0.5 * heaps.y) / WIND_RIPPLES);
    found.tone += 0.05 * rippled * sin(along);
    found.slope += 0.14 * rippled * cos(along) * RIPPLED_ALONG;
    // The pattern is Mercator's.
    let on_map = select(0.0, 1.0, point.square == MERCATOR);
    return Grain(on_map * found.tone, on_map * found.slope);
}

// Imagery has mountains under as much white as there is snow in pixels of kilometres: it lies on their heights first, and thaws in their valleys and down by the water, where
// this is not frozen. Deserts are bright, and not white; ice is white as a whole.
fn snow_lies(albedo: vec3f, at: vec2u, elevation: Metres, hollow: f32, sin_lat: f32, footprint: Metres) -> vec3f {
    let share = saturate((albedo.b - THAWED.b) / (SNOW.b - THAWED.b));
    let thaws = 0.5 * smoothstep(SNOW_THAWS, 0.0, elevation) * smoothstep(ICY_COASTS.x, ICY_COASTS.y, sin_lat) * smoothstep(ICY_COASTS.w, ICY_COASTS.z, sin_lat);
    // Drifts and bare spots break its edge.
    let drifts = 0.5 * (map_noise(at, 16u, 90u) - 0.5) * shown(footprint, 600.0) + 0.35 * (map_noise(at, 18u, 91u) - 0.5) * shown(footprint, 150.0);
    // How many of all heights of a country are higher: these are nearly normal, of a deviation of 0.4.
    let low = 1.0 / (1.0 + exp(4.3 * hollow)) + thaws + drifts;
    let snowy = smoothstep(0.15, 0.35, share) * smoothstep(NOT_WHITE.x, NOT_WHITE.y, albedo.b / max(albedo.r, 1e-3));
    return mix(albedo, mix(THAWED, SNOW, smoothstep(share + SNOW_EDGE, share - SNOW_EDGE, low)), snowy * smoothstep(1.0, 0.9, share));
}

// `direction`: of the sight; `lies`: the normal of what is drawn, which knows less of the relief; `width`: of the pixel towards the shore; `washed`: how far waves run up the shore; nothing grows there.
fn lit_ground(at: Place, direction: vec3f, up: vec3f, lies: vec3f, footprint: Metres, width: Metres, made: Made, light: Daylight, washed: Metres) -> LitGround {
    let point = at.point;
    let part = at.part;
    let sin_lat = at.sin_lat;
    let distance = at.distance;
    let ground = at.ground;
    let east = east_at(up);
    let north = cross(up, east);
    let terrain = terrain_slope(point, sin_lat, footprint);
    let slope = slope_shown(ground) * terrain + made.slope;
    let normal = normalize(up - slope.x * east - slope.y * north);
    // Where the shore crosses a pixel its land is what shows of its ground.
    let sight = sinking(point, direction, up, LEAST_SINKING);
    let is_bed = BED_ALONE || ((ocean_share(ground, width) >= 1.0) & (ground.ocean_shore > edge_of_beach(width)));
    // There is nothing of the land on it: so far out the sea itself lays the sand.
    let is_apart = BED_ALONE || (is_bed & ((-ground.elevation >= BED_AS_BEACH) | (ground.ocean_shore >= SHORE_SAND.y)));
    let ashore = smoothstep(SHORE_SAND.y, SHORE_SAND.x, ground.ocean_shore);
    var albedo: vec3f;
    var shaded = normal;
    let kind_seen = smoothstep(KIND_SEEN.y, KIND_SEEN.x, footprint);
    var rocky = at.kind.rock * kind_seen;
    if rocky > 0.0 {
        let covers = mix(COVES.x, COVES.y, rocky);
        rocky = smoothstep(0.0, 0.2, rocky) * smoothstep(covers + COVES.z, covers, map_noise(point.at, 15u, 83u));
    }
    var built = NOT_BUILT_UP;
    if TOWN && !is_apart { built = built_up(point.at, max(length(terrain), length(slope)), footprint); }
    // Towns have quays where few waves come, and beaches else.
    let bank = kind_seen * max(at.kind.bank, built.share * smoothstep(QUAYS.x, QUAYS.y, at.kind.bank));
    let towers = made.towers * kind_seen;
    var usual_width = BEACH * mix(mix(mix(1.0, ROCKY_WIDTH, rocky), BANK_WIDTH, bank), WALLED_WIDTH, towers);
    let banked = mix(mix(BANK, SHORE_ROCK, rocky), MUD, smoothstep(WARM.y, WARM.x, abs(sin_lat)) * (1.0 - built.share));
    let hard = max(smoothstep(0.04, 0.12, length(terrain)), ground.cliff);
    let plain_sand = mix(mix(mix(mix(SAND, SHORE_ROCK, rocky), banked, bank), WAVE_CUT, select(towers, 0.0, is_bed)), ROCK, hard);
    var sand = plain_sand;
    var grown = smoothstep(0.2, 1.2, -ground.ocean_shore / usual_width);
    var sandy = smoothstep(0.15, 0.09, length(terrain)) * (1.0 - ground.cliff) * (1.0 - 0.7 * rocky) * (1.0 - 0.9 * bank);
    var shines = vec3f(0.0);
    var town_light = vec2f(1.0);      // of the sun's and the sky's
    var rises = vec2f(0.0);
    var own_shade = 0.0;
    var standing = NOTHING_STANDS;
    var flat = 1.0;
    var grain = Grain(0.0, vec2f(0.0));
    // Pixels on a slope that faces the eye are not as long as on the level.
    let across = distance * frame.pixel_angle;
    let growth = min(footprint, ground_footprint(across, direction, lies));
    if FINE && GROWTH && !is_apart { grain = grain_at(point, part, sqrt(growth * across), rocky); }
    if IMAGERY && !is_apart {
        let told = imagery_albedo(point, sin_lat, footprint);
        albedo = told;
        if FINE { albedo = mix(told, snow_lies(told, point.at, ground.elevation, made.hollow, sin_lat, footprint), made.about * smoothstep(SNOW_SEEN.y, SNOW_SEEN.x, footprint)); }
        let snowy = smoothstep(0.3, 0.6, albedo.b);
        sandy *= 1.0 - snowy;
        sand = mix(sand, albedo, snowy);
        if FINE {
            // What stands hides the ground between, the more so the flatter a sight is: what lies flat would be seen as streaks.
            flat = mix(1.0, across / growth, greenness(albedo));
            var detail = NO_DETAIL;
            if DETAIL { detail = ground_detail(point.at, growth); }
            let green = greenness(albedo);
            let farm = farmed(told, greenness(told), length(terrain), ground.elevation, sin_lat, detail.tillage) * smoothstep(FARMED_FROM.x, FARMED_FROM.y, -ground.ocean_shore) * (1.0 - built.within);
            // What stands on a slope stands upright: a sight and the sun's light sink to that, not to the level.
            let raised = lies / max(dot(lies, up), 0.1);
            let sinks = max(-dot(direction, raised), LEAST_SINKING);
            let sight_over = sight * max(-dot(direction, up), LEAST_SINKING) / sinks;
            let sunlight = sinking(point, -frame.light, up, 0.4) * max(dot(frame.light, up), 0.4) / max(dot(frame.light, raised), 0.4);
            // Hills are as rough as the ground about them is steep, and none stand where the relief has its own.
            let rough = select(0.22 * min(0.2 + 7.0 * length(terrain), 1.3), 0.0, is_bed) * (1.0 - made.whole);
            let hills = rough * east_north_of(point, detail.rise * vec2f(1.0, -1.0));
            // Rock stands out where it is steep, more of it on this slope than on that, and of this layer than of that; woods stand elsewhere.
            let holds = green * max(smoothstep(WARM.y, WARM.x, abs(sin_lat)), made.carved);
            let steep = smoothstep(0.2, 0.7, length(slope) + length(hills) - mix(HOLDS_ON, HOLDS_ON_VALLEYS, made.carved) * holds + mix(0.1, 0.3, holds) * detail.tone);
            var wall = NO_WALL;
            if DETAIL { wall = wall_at(pattern_place(point, part), slope, ground.elevation + made.height, across, max(towers, steep) <= 0.0); }
            let rock = 0.8 * (1.0 - towers) * saturate(steep + 6.0 * LAYERED * steep * (1.0 - steep) * wall.layers);
            let bare_wall = towers * wall.bare;
            let all_woods = wooded(albedo, green) * (1.0 - farm) * (1.0 - built.share);
            let woods = select(woods_at(all_woods, detail.stands), all_woods, is_bed);
            // Woods and grass hang over the water here, where the shore is steep or rock, and there is a beach or bare rock there.
            var beach = usual_width;
            if DETAIL {
                let open_shore = smoothstep(-0.12, 0.2, map_noise_rise(point.at, 15u, 87u).x + 0.7 * map_noise_rise(point.at, 17u, 88u).x);
                usual_width *= mix(1.0, mix(OVERHUNG_WIDTH, OPEN_WIDTH, open_shore), max(all_woods, 0.8 * max(rocky, hard)) * kind_seen);
                beach = beach_width(point.at, usual_width);
            }
            let inland = (-ground.ocean_shore - mix(1.6, 0.6, rocky) * washed) / beach;
            let frayed = inland + 2.0 * FRAYED * (detail.tone + 3.0 * grain.tone);
            sand *= 1.0 + dot(detail.clumps, SAND_MOTTLES);
            grown = overgrown(inland, detail.tone + 2.5 * grain.tone, footprint) * mix(SPARSE_GRASS, 1.0, smoothstep(0.9, 2.0, frayed));
            // Much grows where it is dark.
            let bent = moved_by(FinePoint(point.at, part), BENT * detail.bent);
            let open = smoothstep(0.0, 0.2, inland) * 0.5 * (inland + FRAYED * detail.coarse);
            let trees = select(woods * smoothstep(0.1, 0.6, open) * (1.0 - max(rock, bare_wall)), 0.0, is_bed);
            if GROWTH {
                standing = plants(bent, trees, smoothstep(FIRS.x, FIRS.y, abs(sin_lat)), green, -detail.clumps, farm, open, sight_over, sunlight, sinks * distance, growth, across);
                standing.shade = select(standing.shade, 0.0, is_bed);
            }
            albedo = detailed_albedo(albedo, green, farm, detail, WOODS_TONE * (all_woods - woods), standing.tone, flat);
            rises = select(STANDING, 0.0, is_bed) * east_north_of(point, standing.rise * vec2f(1.0, -1.0));
            let tops = WOODS_ROUGH * trees * east_north_of(point, detail.tops * vec2f(1.0, -1.0));
            shaded = normalize(normal - (hills.x + tops.x) * east - (hills.y + tops.y) * north);
            // Seen with the sun behind oneself woods show no shadows of their own, and towards it little else: as the crowns do where they show.
            let towards_sun = 0.5 - 0.5 * dot(direction, frame.light);
            own_shade = trees * mix(HOT_SPOT * (towards_sun * towards_sun - HOT_SPOT_MEAN), CROWN_GAIN, standing.cover);
            albedo = mix(albedo, ROCK * mix(1.0, OVERGROWN_ROCK, holds) * max(1.0 + ROCK_LAYERS * wall.layers - ROCK_STREAKS * wall.streaks, 0.3), rock);
            albedo = mix(albedo * mix(1.0, WOODED, green * towers), wall.albedo, bare_wall);
            var hidden = bare_wall;
            var house = 0.0;
            if TOWN {
                let share = select(built.share, 0.0, is_bed) * (1.0 - rock);
                built.edges.values.z = (inland - 1.0) * beach;
                built.edges.right.z = -ground.shore_rise.x;
                built.edges.down.z = -ground.shore_rise.y;
                built.edges.values.w = min(built.edges.values.w, 0.5 - rock);
                let town = houses(FinePoint(point.at, part), built, sin_lat, green, sight_over, sunlight, sinks * distance, across, !is_bed);
                house = town.stands;
                let paved = max(share * town.cover, house);
                albedo = mix(albedo, town.albedo, paved);
                hidden = max(hidden, paved);
                town_light = mix(vec2f(1.0), vec2f(town.sun, town.sky), max(share, house));
                shines = max(share, house) * lamps_lit(up) * town.shines;
                own_shade *= 1.0 - house;
                shaded = normalize(mix(shaded, normal, house));
            }
            rises *= 1.0 - hidden;
            standing.cover *= 1.0 - hidden;
            standing.shade *= 1.0 - hidden;
            grown = max(grown, max(0.85 * standing.cover, house));
        }
    } else if !is_apart {
        albedo = natural_colour(ground.elevation + made.height, length(slope), sin_lat, patchiness(point.at, footprint));
    }
    if is_bed {
        let depth = max(-ground.elevation, 0.0);
        let by_beach = mix(plain_sand, sand, ashore);
        albedo = mix(MOIST_SAND * by_beach, mix(bed_colour(depth), mix(mix(ROCKY_BED, SCOURED_BED, at.kind.scoured), BANK_BED, bank), at.bed * (1.0 - towers) * (1.0 - ground.corals.y) * max(0.85 * rocky, bank)), smoothstep(0.0, BED_AS_BEACH, depth));
        if FINE && SHOWS_COVER {
            // By the waterline it is the beach's sand, with its grain.
            let meadows = meadows_to(attenuation(water_kind(point, sin_lat, depth)).g);
            albedo = with_coral_sand(albedo, depth, ground.corals.y * smoothstep(SHORE_SAND.x, SHORE_SAND.y, ground.ocean_shore));
            albedo = covered_bed(point, albedo, depth, meadows, ground.corals, footprint) * max(1.0 + grain.tone * ashore * smoothstep(GRAIN_TO, 0.0, depth), 0.2);
        }
    }
    let bare = select((1.0 - grown) * smoothstep(8.0, 1.0, ground.elevation) * saturate(usual_width / footprint), 0.0, is_bed);
    albedo = mix(albedo, sand, bare);
    shines *= 1.0 - bare;
    town_light = mix(town_light, vec2f(1.0), bare);
    if FINE && GROWTH && !is_bed {
        let boulders = mix(vec2f(1.0), BOULDERS, rocky);
        albedo *= max(1.0 + mix(2.5 * flat, boulders.x, bare) * grain.tone, 0.2);
        rises = mix(rises, boulders.y * grain.slope, bare);
    }
    shaded = normalize(mix(shaded, normal, bare * sandy) - rises.x * east - rises.y * north);
    // Leaves let light through to the side that is turned away.
    let faces = max(dot(frame.light, shaded), THROUGH_LEAVES * standing.cover * max(dot(frame.light, up), 0.0));
    let sun = light.sun * (1.0 + own_shade) * max(faces, 0.0) * smoothstep(-0.02, 0.03, dot(frame.light, up)) * (1.0 - 0.85 * standing.shade) * town_light.x;
    // Valleys see less of the sky.
    let ambient = light.sky * (0.6 + 0.4 * dot(shaded, up)) * (1.0 + HOLLOW * min(made.hollow, 0.0)) * (1.0 - 0.5 * standing.shade) * town_light.y;
    return LitGround(normal, albedo, albedo / PI * (sun + ambient) + shines, select(sandy * (1.0 - grown), 0.0, is_bed));
}
