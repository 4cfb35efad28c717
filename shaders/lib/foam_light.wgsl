// How foam looks from above: what it hides of the water and the light that it sends back.
#import atmosphere

const FOAM_ALBEDO = 0.55;       // of dense foam in visible light (C. Whitlock, D. Bartlett, E. Gurganus 1982)
const THIN_FOAM_COLOUR = vec3f(0.94, 1.014, 1.04);  // a single layer of bubbles stands in the water, which takes red; its luminance is 1
const FOAM_WRAP: f32 = 0.25;     // light goes through foam and comes out on its shaded side; share of the sun's that does

const STEEPEST_FOAM: f32 = 0.9;  // slope that foam lies at: it fills what waves fold

struct Foam {
    white: f32,            // opacity, 0…1: the reflectance over that of dense foam
    open: f32,             // light that reaches it, of what foam without creases gets
    plume: f32,            // share of the water below that is full of bubbles
    shade: f32,            // light that it takes from the water beside it, of all
    slope: vec2f,          // of the foam's own surface on the water's, x east, y north
}

// Foam of no shape.
fn flat_foam(white: f32, plume: f32) -> Foam {
    return Foam(white, 1.0, plume, 0.0, vec2f(0.0));
}

const FOAM_SPREADS: f32 = 0.4;   // share of the sun's light that goes on in the foam beyond its own lumps: their shaded sides are as warm; ours

const SKY_LEANS: f32 = 0.55;     // how much brighter the sky is on the sun's side than in the mean, to a slope of 45 degrees, were all its light the sun's; ours

fn wrapped_sun(normal: vec3f, to_sun: vec3f) -> f32 { return max((dot(normal, to_sun) + FOAM_WRAP) / (1.0 + FOAM_WRAP), 0.0); }

// Radiance of dense foam on water with a `normal`; `sun` and `ambient` are irradiances, of a plane that faces the sun and of a level one; `sunny`: the share
// of its beam in both, were there no clouds: these leave the sky the lighter where it stands.
fn foam_radiance(foam: Foam, normal: vec3f, up: vec3f, to_sun: vec3f, sun: vec3f, ambient: vec3f, sunny: f32) -> vec3f {
    let slope = normal / max(dot(normal, up), 0.1) - up - vec3f(foam.slope, 0.0);
    let own = normalize(up + slope * inverseSqrt(1.0 + dot(slope, slope) / (STEEPEST_FOAM * STEEPEST_FOAM)));
    let wrapped = mix(wrapped_sun(own, to_sun), wrapped_sun(normal, to_sun), FOAM_SPREADS);
    // What a slope faces of an even sky; its steepest edges, of which pixels show but few, count as 45 degrees.
    let open = 0.5 + 0.5 * inverseSqrt(1.0 + min(dot(foam.slope, foam.slope), 1.0));
    let lean = 1.0 + SKY_LEANS * sunny * dot(own, to_sun - dot(to_sun, up) * up);
    let colour = mix(THIN_FOAM_COLOUR, vec3f(1.0), saturate(2.0 * foam.white));
    return FOAM_ALBEDO / PI * foam.open * colour * (sun * wrapped + ambient * open * lean);
}
