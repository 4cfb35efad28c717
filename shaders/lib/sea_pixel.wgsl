// What a pixel of the sea shows over what the land pass left. The water class decides what is sea, never the depth buffer.
// Long, but one thing: whoever asks why a pixel of the sea looks as it does reads it from top to bottom, each step from a library.
// Who imports this declares `MEASURED`, `UNDER_WATER`, `SPRAY` and `FINE` (src/pass/kind.rs), `FOAM` as more than a share (src/pass/ocean.rs), and what of the
// sea shows at all (src/pass/look.rs): `WAVES` of the patches, the far sea's `NOISE`, `SURF` on shores.
#import places
#import waves
#import held
#import shore_trains
#import lace
#import rollers
#import limb
#import mirrored_land
#import scene
#import crest_pixels
#import gusts
#import shore_pixels
#import water
#import spray
#import driven_spray
#import surf
#import translucence
#import window
#import output

@group(2) @binding(0) var scene_colour: texture_2d<f32>;     // to an eye in the water: the map of caustics
@group(2) @binding(1) var scene_depth: texture_depth_2d;

const MIRRORS_CLOUDS = FINE;
const SPRAY_AMID = vec2f(5.0, 20.0);   // heights of an eye, of the spray's, between which it is no longer under the same clouds as the spray that it sees
const FARTHEST_SURFACE: Metres = 1000.0;
const MIRROR_PIXELS = 2.0;     // seen from below waves are as long as so many pixels, at least
const LONGEST = 1000.0;        // of a pixel on grazed water, of its width
const STREAKS_BLUR = 1.4;      // how much wider pixels are to storms' foam than to other: the finest of its streaks would be rows of dots
const FOLDS = 0.2;             // heights of the picture within its rim that stand for the bed beside it

// Radiance of the scene in a pixel, and how much more light waves have gathered there than a flat surface, of bed_light.wgsl.
fn scene_seen(pixel: vec2u) -> vec4f {
    let seen = textureLoad(scene_colour, pixel, 0);
    return vec4f(seen.rgb / max(frame.exposure, 1e-9), gathered_on(seen));
}

// The pixel of the scene that shows a place on the bed: `own`, where something else stands before it, or sky. What lies beside the picture is
// taken to be like what lies within, the farther from its rim the farther beside, but never farther than FOLDS: the rim, repeated, would be
// streaks, and what lies below an eye close over the water is many pictures away.
fn pixel_of_bed(own: vec2u, place: vec3f) -> vec2u {
    let clip = frame.clip_from_local * vec4f(place, 1.0);
    let shown = (vec2f(0.5, -0.5) * clip.xy / max(clip.w, NEAR) + 0.5) * frame.viewport;
    let last = frame.viewport - 1.0;
    let within = clamp(shown, vec2f(0.0), last);
    let beside = (shown - within) / (FOLDS * frame.viewport.y);
    let pixel = vec2u(clamp(within - FOLDS * frame.viewport.y * beside / (1.0 + abs(beside)), vec2f(0.0), last));
    let nearness = textureLoad(scene_depth, pixel, 0);
    return select(pixel, own, (nearness * nearest_bed(0.9 * clip.w) > NEAR) | (nearness == 0.0));
}

// How long a pixel is along the wind and across it, by how long it is along the sight and across that.
fn streaks_seen(direction: vec3f, up: vec3f, long: Metres, wide: Metres) -> vec2f {
    let level = normalize(direction - dot(direction, up) * up + 1e-6 * vec3f(1.0, 0.0, 0.0));
    let wind = wave_cells[0].wind.x * wave_cells[0].axis_x + wave_cells[0].wind.y * wave_cells[0].axis_y;
    let along = min(abs(dot(level, wind)), 1.0);
    let beside = sqrt(1.0 - along * along);
    return vec2f(length(vec2f(along * long, beside * wide)), length(vec2f(beside * long, along * wide)));
}

// What it shows; `is_sea`: whether that is the sea, or what stands there without it.
struct SeaPixel { colour: vec4f, is_sea: bool }

const NO_SEA = SeaPixel(vec4f(0.0), false);

fn sea_pixel(in: Patch, pixel: vec2u) -> SeaPixel {
    let right = in.right;
    let down = in.down;
    var distance = length(in.moved);
    let direction = in.moved / max(distance, 1e-3);
    let is_chord = waves_are_pixels(distance);
    // Far away the exact hit of the pixel's own ray replaces the chord of its triangle.
    var rest = in.rest;
    var moved = in.moved;
    var limb = Limb(1.0, 0.0, vec2f(0.0));
    var misses = false;
    if is_chord {
        let ray = eye_ray(direction);
        distance = surface_hit(ray);
        if ray.c > 0.0 { limb = limb_of(ray, direction); }
        misses = distance < 0.0;
        if misses {
            // A measured layer says what lies under the middle of a pixel; a picture, what fills it.
            if limb.share <= 0.0 || MEASURED {
                return NO_SEA;
            }
            distance = limb.distance;
        }
        rest = direction * distance;
        moved = rest;
    }
    // No eye in the water sees so far, nor through the earth.
    if UNDER_WATER && !MEASURED && distance > FARTHEST_SURFACE {
        return NO_SEA;
    }
    // Land in front of the water hides it, its bed does not.
    let land_depth = textureLoad(scene_depth, pixel, 0);
    let axis_distance = dot(moved, frame.ray_forward);
    // Depth = NEAR / distance. The bed that an eye in the water sees is no triangles'.
    if land_depth * select(nearest_bed(axis_distance), axis_distance, UNDER_WATER && !MEASURED) > NEAR || axis_distance < frame.lens {
        return NO_SEA;
    }

    let dn = normal_delta(rest);
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let sin_lat = frame.sin_lat + sin_lat_delta(dn);
    let grazing = max(abs(dot(direction, up)), 0.002);
    let across = distance * frame.pixel_angle;
    var footprint = across / sqrt(grazing);
    // From below the water is a mirror that turns twice as far as its slopes: as long as the pixel is along it, no slope must stand alone there.
    if UNDER_WATER { footprint = across * clamp(MIRROR_PIXELS * right * down / (across * across), 1.0, LONGEST); }
    if !MEASURED && !is_chord && !UNDER_WATER { footprint = behind_crest(footprint, right * down); }
    let point = map_point(dn);
    let ground = ground_amid(point, sin_lat, max(across, 1.0), in.grid);
    // Pixels that the shore crosses show sea by its share of them.
    let sight = sinking(point, direction, up, LEAST_SINKING);
    let to_shore = width_to_shore(ground, sight, across);
    let share = ocean_share(ground, to_shore);
    if share <= 0.0 {
        return NO_SEA;
    }

    let depth = ocean_depth(ground, footprint, share);
    let alpha = water_alpha(depth);
    var sea = behind_reefs(local_sea(point), ground.waves);
    // Of all waves, those of shores too.
    let height = held_share(depth, sea.height) * sea.height;
    var waves = NO_SHORE_WAVES;
    let incoming = in.incoming * ground.waves;
    // Surf on a coral reef is off the shore, but at its own.
    let surf_shore = ground.ocean_shore * (1.0 - ground.corals.x);
    if SURF {
        waves = shore_waves_at(point, -ground.elevation, -ground.plain, ground.waves, ground.ocean_shore, ground.face, distance, footprint, footprint);
        waves.white *= mix(comes_ashore(waves.way, ground.shore_rise), 1.0, ground.corals.x);
        sea = left_by_trains(sea, waves.share);
    }
    var ripples = 1.0;
    if WAVES && FINE && !MEASURED { ripples = ripples_at(point, sin_lat, in.height / max(height * frame.wave_height, 0.01), footprint); }
    var slopes = slopes_in(sea, rest, distance, footprint, ripples);
    slopes.rough += 0.5 * waves.hidden;
    let calmed = held_share(depth, sea.height);
    // There are so many whitecaps, and so much film of old ones, as waves are high: their Reynolds number counts (D. Zhao and Y. Toba 2001).
    let whitened = calmed * sea.height;
    let slope = slopes.slope * calmed + waves.slope;
    let normal = normalize(up + vec3f(-slope.x, -slope.y, 0.0));
    if UNDER_WATER {
        var light = daylight_at(frame.light.z);
        if CLOUDS { light = clouded_daylight_at_eye(light); }
        let w = underwater(light);
        let seen = surface_from_below(w, vec2f(pixel) + 0.5, moved, direction, normal, up, calmed * calmed * slopes.rough, depth, ground.corals);
        if !MEASURED { return SeaPixel(shown_in_water(w, seen), true); }
        return SeaPixel(measured_output(Measured(rest, distance, depth, alpha, in.height, normal, 1.0, mix_weights(distance).y, vec3f(0.0)), seen), true);
    }
    let foam_at = foam_coordinates(rest);
    // Edges of foam are the sharpest lines of the sea: for them the pixel is nearly as wide as it is long over grazed water.
    let faced = faced_by_wave(footprint, right * down);
    let foam_footprint = faced * across / pow(grazing, 0.65);
    var foam = flat_foam(0.0, 0.0);
    var facets = MEAN_FACETS;
    if FOAM {
        var asked = foam_at;
        if FINE { asked = ragged(foam_at, foam_footprint); }
        let lies = foam_share(asked, in.height, sea.height, foam_footprint, FINE);
        var shares = whitened * vec2f(lies.all, lies.young);
        let width = faced * footprint;
        let long = max(width, 0.5 * max(right, down));
        let wide = mix(width, STREAKS_BLUR * long, storm());
        var seen = lace_in(foam_at, wide, streaks_seen(direction, up, wide, min(wide, STREAKS_BLUR * max(across, 0.5 * min(right, down)))), 1, FINE);
        var dense = usually_dense_from(shares.x);
        if FINE {
            let fresh = freshness(shares);
            seen = on_front(seen, shares.y, lies.slope, fresh);
            shares = standing(vec2f(fronted(shares.x, fresh), fronted(shares.y, fresh)), grazing);
            if SURF {
                let surf = surf_at(waves, surf_shore, depth, incoming, to_shore, seen.level.z);
                let white = at_waterline(ground.ocean_shore, seen.level.z) * surf.xy;
                seen = in_surf(seen, foam_at, width, white.x / max(white.x + shares.x, 1e-4));
                shares = max(shares, white);
                seen.hidden += surf.z * surf.z;
            }
            facets = facets_at(foam_at, across, grazing);
            seen = on_folds(seen, slopes.folds, FOLDED);
            seen = on_crests(seen, 4.0 * in.height / max(height * frame.wave_height, 0.01), crests_kept(footprint));
            dense = fresh_dense_from(shares.y, seen.fresh);
        }
        foam = foam_of(shares.x, dense, height, seen, FINE);
        if FINE { foam.slope += whitened * roller_slope(lies.slope); }
    } else {
        var share = whitened * share_from_afar(in.height, sea.height, foam_footprint);
        if SURF { share = max(share, surf_at(waves, surf_shore, depth, incoming, to_shore, 0.0).x); }
        foam = mean_foam(share, mean_dense_from(share, FINE), height, FINE);
    }
    let clear = daylight_at(dot(frame.light, up));
    var light = clear;
    if CLOUDS { light = clouded_daylight(clear, up, shadow_of_pixel(rest, in.shadow, FINE)); }
    let scene = scene_seen(pixel);
    let behind = scene.rgb;
    var bed = Bed(behind, 2.0 * depth, scene.a);
    if FINE && alpha < OPAQUE_ALPHA {
        let sight = sight_to_bed(direction, normal, up, depth);
        let below = scene_seen(pixel_of_bed(pixel, moved + sight));
        bed = Bed(below.rgb, depth + length(sight), below.a);
    }
    let kind = water_kind(point, sin_lat, depth);
    var glow = vec3f(0.0);
    if WAVES && FINE {
        glow = crests_shown(distance) * crest_light(direction, normal, up, in.ahead, kind, foam.plume, light.sun);
    }
    var point_of_water = WaterPoint(rest, -direction, up, normal, along_wind(up), slopes.rough * gusts(point, sin_lat, footprint), alpha,
        kind, bed, foam, facets, glow, NO_LAND);
    if FINE && !MEASURED { point_of_water.land = mirrored_land(point_of_water, pixel); }
    let water = water_radiance(point_of_water, light, clear);
    var covers = share;
    if FINE && SURF {
        // Sand that waves run over shines as water does: either mirrors the sky where the other ends, at the place where a sight meets level water, as land has it.
        let beach = edge_seen(to_shore) * (1.0 - ground.cliff) * select(0.0, 1.0, point.square == MERCATOR);
        covers = mix(share, out_of_swash(ground.ocean_shore + in.height * dot(ground.shore_rise, sight), to_shore), beach);
    }
    // The bed has no air before it yet, land has.
    var driven = vec2f(1.0, 0.0);
    if SPRAY && FINE {
        let along_streaks = streaks_seen(direction, up, footprint * footprint / across, across);
        driven = driven_spray(foam_at, along_streaks, grazing, distance, ground.ocean_shore);
        driven = spray_on_crests(driven, 4.0 * in.height / max(height * frame.wave_height, 0.01), crests_kept(footprint));
    }
    // What thick spray hides may lie under other clouds than its near side.
    var near = light;
    if SPRAY && CLOUDS && FINE {
        let hidden = (1.0 - exp(-spray_depth(direction.z, distance))) * smoothstep(SPRAY_AMID.y, SPRAY_AMID.x, frame.eye_altitude / spray_height());
        let clear = daylight_at(frame.light.z);
        near.sun = mix(light.sun, (1.0 - cover_at_eye()) * clear.sun, hidden);
        near.sky = mix(light.sky, clouded_daylight_at_eye(clear).sky, hidden);
    }
    var radiance = through_spray(mix(behind, water, select(1.0, covers, ground.is_ocean)), light, near, up, direction, distance, driven);
    if !ground.is_ocean { radiance = mix(behind, radiance, covers); }
    if limb.share < 1.0 {
        // The scene under the limb is the sea's bed: what is beyond stands beside it.
        let step = select(limb.beyond, vec2f(0.0), misses);
        let beyond = clamp(vec2f(pixel) + step, vec2f(0.0), frame.viewport - 1.0);
        radiance = mix(scene_seen(vec2u(beyond)).rgb, radiance, limb.share);
    }
    if !MEASURED { return SeaPixel(vec4f(radiance * frame.exposure, 1.0), true); }
    return SeaPixel(measured_output(Measured(rest, distance, depth, alpha, in.height, normal, 1.0, mix_weights(distance).y, vec3f(0.0)), radiance), true);
}
