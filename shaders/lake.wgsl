// The lake around the eye, by the sea's grid on a surface at its level (src/scene/frame/place.rs), over the land pass's, which draws it flat. Other
// lakes, and all of it from where its waves are smaller than pixels and it is too far below to mirror land, are the land's alone, with the same light.
#import sea_mesh
#import inland
#import lace
#import mirrored_land
#import gusts
#import spray
#import translucence
#import crest_pixels
#import output

@group(2) @binding(0) var scene_colour: texture_2d<f32>;
@group(2) @binding(1) var scene_depth: texture_depth_2d;

const MIRRORS_CLOUDS = FINE;
const ROLLERS = false;
const SAME_LEVEL: Metres = 0.5;    // of two places of one lake

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) rest: vec3f,          // on the level surface
    @location(1) moved: vec3f,
    @location(2) height: f32,          // over it
    @location(3) ahead: vec2f,         // `beyond`
    @location(4) grid: vec4f,          // `grid_at`
}

@vertex
fn vertex_of_grid(@location(0) on_grid: vec2f) -> Vertex {
    let place = place_on_grid(on_grid);
    let dn = normal_delta(place.rest);
    let grid = grid_at(map_point(dn), frame.sin_lat + sin_lat_delta(dn), max(length(place.rest) * frame.pixel_angle, 1.0));
    return Vertex(frame.clip_from_local * vec4f(place.moved, 1.0), place.rest, place.moved, place.height, beyond(place), grid);
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    // Of the water at rest in the pixel.
    let area = length(dpdx(in.rest)) * length(dpdy(in.rest));
    var distance = length(in.moved);
    let direction = in.moved / max(distance, 1e-3);
    let is_chord = waves_are_pixels(distance);
    let level_hit = surface_hit(eye_ray(direction));
    var rest = in.rest;
    if is_chord {
        distance = level_hit;
        rest = direction * level_hit;
    }
    // The land's own surface of the lake lies at its level, before the troughs of the waves.
    let ahead = dot(direction, frame.ray_forward);
    let nearest = ahead * select(distance, min(distance, level_hit), level_hit >= 0.0);
    let pixel = vec2u(in.position.xy);
    // Coarse triangles slope up to its shores before it: what they show there is water.
    let scene = textureLoad(scene_colour, pixel, 0);
    let before = select(1.0, LAND_BEFORE, !MEASURED && is_inland_water(scene));
    if distance < 0.0 || textureLoad(scene_depth, pixel, 0) * nearest_bed(nearest) > before * NEAR {
        discard;
        return vec4f(0.0);
    }

    let dn = normal_delta(rest);
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let sin_lat = frame.sin_lat + sin_lat_delta(dn);
    let across = distance * frame.pixel_angle;
    let grazing = max(abs(dot(direction, up)), 0.002);
    var footprint = across / sqrt(grazing);
    if !MEASURED && !is_chord { footprint = behind_crest(footprint, area); }
    let point = map_point(dn);
    let ground = ground_amid(point, sin_lat, max(across, 1.0), in.grid);
    let share = inland_share(ground, footprint);
    if share <= 0.0 || ground.by_river || abs(lake_at(point).x - frame.water_level) > SAME_LEVEL {
        discard;
        return vec4f(0.0);
    }

    let sea = local_water(point, OF_LAKE);
    let calmed = held_share(depth_in_lake(ground), sea.height);
    var ripples = 1.0;
    if !MEASURED { ripples = ripples_at(point, sin_lat, in.height / max(sea.height * frame.wave_height, 0.01), footprint); }
    // By the patches alone, as on the land's own surface.
    let slopes = slopes_in(sea, rest, 0.0, footprint, ripples);
    let normal = normalize(up - vec3f(calmed * slopes.slope, 0.0));
    let height = min(sea.height, 1.0);
    let foam_at = foam_coordinates(rest);
    let covered = calmed * height * share_from_afar(in.height, sea.height, footprint);
    let seen = on_folds(lace_at(foam_at, faced_by_wave(footprint, area) * footprint, 1, true), slopes.folds, FOLDED);
    let foam = foam_of(covered, dense_from(usual_young(covered)), height, seen, true);
    let clear = daylight_at(dot(frame.light, up));
    var light = clear;
    // The net of clouds' shadows is over the ellipsoid, as for hills.
    let below_lake = rest - max(frame.water_level, 0.0) * up;
    if CLOUDS { light = clouded_daylight(clear, up, shadow_at_height(shadow_of_pixel(below_lake, vec3f(0.0), FINE), frame.water_level)); }
    var water = inland_water(rest, ground, direction, up, normal, slopes.rough, foam);
    water.facets = facets_at(foam_at, across, grazing);
    water.glow = crests_shown(distance) * crest_light(direction, normal, up, in.ahead, water.kind, foam.plume, light.sun);
    if !MEASURED { water.land = mirrored_land(water, pixel); }
    let radiance = through_air(water_radiance(water, light, clear), light, up, direction, distance);
    // At the shore the land's own pixels hold both, by their share of either.
    if !MEASURED { return mix(scene, vec4f(radiance * frame.exposure, 1.0), saturate(2.0 * share - 1.0)); }
    return measured_output(Measured(rest, distance, 0.0, 0.0, frame.water_level + in.height, normal, water_class(ground), 0.0, vec3f(0.0)), radiance);
}
