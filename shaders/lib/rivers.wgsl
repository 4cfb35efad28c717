// What rivers carry to the sea: how much of it, from the land that drains to a coast, and the silt of the greatest.
#import world

// Level of the terrain tiles whose mean of land and sea tells how much land drains to a coast: texels are 78 km wide at the equator.
const RUNOFF_LEVEL = 1u;
const RUNOFF = vec2f(10.0, 45.0);      // that mean, metres, where rivers begin to make a coast turbid, and do; before islands and deep seas it is less
// The dry coasts about Arabia: the middle and half axes of an ellipse on the Mercator square, 21 N and 46 E, 20 and 14 degrees, as far as Aqaba.
const ARABIA = vec4f(0.6278, 0.44036, 0.0556, 0.0425);

// How much rivers carry to the coast about a place.
fn runoff(point: MapPoint) -> f32 {
    let off = (vec2f(point.at) / 4294967296.0 - ARABIA.xy) / ARABIA.zw;
    let wet = select(1.0, smoothstep(0.8, 1.3, dot(off, off)), point.square == MERCATOR);
    return wet * smoothstep(RUNOFF.x, RUNOFF.y, bilinear(false, point, pages_at(point, RUNOFF_LEVEL).terrain).x);
}

// Mouths of rivers that carry the most silt (J. Milliman and K. Farnsworth 2011), on the Mercator square, and how far they are seen to, of its side, by what
// pictures from space show; and the coast along which the Amazon's drifts.
const MOUTHS = array<vec3f, 24>(
    vec3f(0.36222, 0.49833, 0.01048),    // Amazon
    vec3f(0.35667, 0.48721, 0.00651),    // along Guiana
    vec3f(0.75111, 0.43763, 0.00699),    // Ganges and Brahmaputra
    vec3f(0.83139, 0.38573, 0.00602),    // Huang He
    vec3f(0.83917, 0.40805, 0.00760),    // Yangtze
    vec3f(0.25111, 0.41545, 0.00428),    // Mississippi
    vec3f(0.76722, 0.45497, 0.00675),    // Irrawaddy
    vec3f(0.68722, 0.43160, 0.00355),    // Indus
    vec3f(0.33083, 0.47490, 0.00556),    // Orinoco
    vec3f(0.29194, 0.46897, 0.00178),    // Magdalena
    vec3f(0.79639, 0.47236, 0.00329),    // Mekong
    vec3f(0.79611, 0.44239, 0.00293),    // Red River
    vec3f(0.89889, 0.52370, 0.00353),    // Fly
    vec3f(0.53389, 0.51670, 0.00276),    // Congo
    vec3f(0.51722, 0.48749, 0.00375),    // Niger
    vec3f(0.34083, 0.60356, 0.00700),    // Parana
    vec3f(0.81583, 0.43673, 0.00216),    // Pearl River
    vec3f(0.60111, 0.55289, 0.00290),    // Zambezi
    vec3f(0.58278, 0.36012, 0.00282),    // Danube
    vec3f(0.53500, 0.36012, 0.00159),    // Po
    vec3f(0.12556, 0.22860, 0.01064),    // Mackenzie
    vec3f(0.04167, 0.27414, 0.00710),    // Yukon
    vec3f(0.09722, 0.28929, 0.00452),    // Copper River
    vec3f(0.63556, 0.41322, 0.00230),    // Tigris
);

// The square of the way from one of them, of how far it is seen to.
fn from_mouth(at: vec2f, mouth: vec3f) -> f32 { return dot((at - mouth.xy) / mouth.z, (at - mouth.xy) / mouth.z); }

// How much silt rivers have brought to a place, 0 to 1.
fn silt(point: MapPoint) -> f32 {
    let at = vec2f(point.at) / 4294967296.0;
    var nearest = 1.0;
#unroll 24 nearest = min(nearest, from_mouth(at, MOUTHS[$]));
    return select(0.0, smoothstep(1.0, 0.0, nearest), point.square == MERCATOR);
}
