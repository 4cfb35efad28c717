//! Clouds seen from above them, from summits to space.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::frame::Output;

use crate::clouds::{DATA, SIZE, green_light, picture};

#[test]
fn closed_clouds_reflect_what_clouds_do() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut brightness = Vec::new();
    for lon in [-60, -45, -30] {
        // Straight down from 5 km, below those of ice, under a sun near the zenith.
        let hour = 12 - lon / 15;
        let state =
            render::parse_state(&format!("#view=15,{lon},5000&clouds=1&time=2026-05-01T{hour}:00:00Z")).unwrap();
        let (frame, _) = render::draw(&mut renderer, &state, [64, 36], Output::Picture).unwrap();
        let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
        let green = bytes.chunks_exact(8).map(|texel| half::f16::from_le_bytes([texel[2], texel[3]]).to_f64());
        let mean = green.sum::<f64>() / (64.0 * 36.0) / f64::from(frame.uniform.exposure);
        brightness.push(std::f64::consts::PI * mean / f64::from(frame.uniform.light.z));
    }
    println!("closed clouds have {brightness:.3?} of the brightness of white ground in the sun beyond the air");
    // An optical depth t gives t / (t + 7.7): 0.44 and 0.72 for the depths of 6 and 20 between which most closed water clouds lie.
    assert!(brightness.iter().all(|share| (0.44..0.72).contains(share)), "{brightness:?}");
}

#[test]
fn closed_clouds_have_relief_from_above() {
    const SIZE: [u32; 2] = [160, 90];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut unevenness = Vec::new();
    for lon in [-60, -45, -30] {
        // Straight down from 5 km, below clouds of ice, under a sun 40 degrees high.
        let hour = 15 - lon / 15;
        let link = format!("#view=15,{lon},5000&clouds=0.95&quality=high&time=2026-05-01T{hour}:20:00Z");
        let green = green_light(&mut renderer, &link, SIZE);
        let mean = green.iter().sum::<f64>() / green.len() as f64;
        let square = green.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / green.len() as f64;
        unevenness.push(square.sqrt() / mean);
    }
    let mean = unevenness.iter().sum::<f64>() / 3.0;
    println!("the brightness of closed clouds deviates by {unevenness:.3?} of its mean, {mean:.3} on average");
    // Under two level streams, which know no sides, it was 0.143.
    assert!((0.18..0.35).contains(&mean), "{unevenness:?}");
}

#[test]
fn sunlit_clouds_are_not_burnt_from_above() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    for view in ["-18,-130,30000,60,55&time=2026-06-12T19:00:00Z", "30,-40,12000,60,60&time=2026-06-12T15:00:00Z"] {
        let pixels = picture(&mut renderer, &format!("#view={view}"), [320, 180]);
        let mut green: Vec<u8> = pixels.chunks_exact(4).map(|pixel| pixel[1]).collect();
        green.sort_unstable();
        let [middle, bright] = [green.len() / 2, green.len() * 95 / 100].map(|at| green[at]);
        println!("{view}: half below {middle}, a twentieth over {bright}");
        // White, with room over it for what is whiter.
        assert!(middle > 180 && bright < 230, "{view}: {middle}, {bright}");
    }
}

#[test]
fn clouds_at_the_terminator_are_dim_and_not_orange_seen_from_space() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // The terminator goes through the middle of the disc.
    let link = "#view=-20,60,8000000&time=2026-11-20T13:20:00Z&quality=high&layers=-stars";
    let pixels = picture(&mut renderer, link, [320, 180]);
    let part = |found: &dyn Fn(&[u8]) -> bool| pixels.chunks_exact(4).filter(|p| found(p)).count();
    let lit = part(&|p| p[..3].iter().map(|v| u32::from(*v)).sum::<u32>() > 60);
    let orange = part(&|p| p[0] > p[2].saturating_add(25));
    println!("{orange} of {lit} lit pixels are orange");
    // Deserts and the glint of the sun are no part of this view. With tops at 2.1 km in a low sun's full light 4 % are.
    assert!(lit > 15_000 && orange * 200 < lit, "{orange} of {lit}");
}

/// Of the middle of a picture, how much pixels differ from the mean of their four neighbours, of how much they do from the one beside them, both
/// squared: 0.62 of noise, in which no pixel tells of another.
fn sharpness(green: &[f64], [width, height]: [u32; 2]) -> f64 {
    let at = |x: u32, y: u32| green[(y * width + x) as usize];
    let middle = || (height / 3..2 * height / 3).flat_map(move |y| (width / 3..2 * width / 3).map(move |x| (x, y)));
    let beside = |x, y| 0.25 * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1));
    let apart = middle().map(|(x, y)| (at(x, y) - beside(x, y)).powi(2)).sum::<f64>();
    apart / middle().map(|(x, y)| (at(x, y) - at(x - 1, y)).powi(2)).sum::<f64>()
}

#[test]
fn clouds_from_space_are_not_out_of_focus() {
    const SIZE: [u32; 2] = [320, 180];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // The first from where half a picture is laid over the whole one, whose pixels are as wide as those of a picture of 540 rows from 3,000 km; the second
    // from twice as high as pictures of the whole globe begin. `soft`: what they are where the smaller picture is not sharpened, and where as much of the
    // field is hidden from space as near it.
    for (altitude_m, is_globe, soft) in [(1_000_000, false, 0.051), (4_200_000, true, 0.171)] {
        let link = format!("#view=25,-40,{altitude_m},0,0&clouds=0.5&time=2026-06-21T16:30:00Z&quality=high");
        let state = render::parse_state(&link).unwrap();
        let (frame, _) = render::draw(&mut renderer, &state, SIZE, Output::Picture).unwrap();
        assert_eq!(frame.is_globe(), is_globe);
        let found = sharpness(&green_light(&mut renderer, &link, SIZE), SIZE);
        println!("from {altitude_m} m {found:.3}");
        // 0.098 and 0.357.
        assert!(found > 1.7 * soft && found < 2.6 * soft, "{found}");
    }
}

#[test]
fn no_line_of_far_land_lies_across_near_clouds() {
    const SIZE: [u32; 2] = [640, 360];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // From within clouds before the Alps, which rise over the ellipsoid's horizon, in row 64.
    let link = "#view=44.95,12.35,1500,250,74&time=2026-06-10T09:00:00Z";
    let pixels = picture(&mut renderer, link, SIZE);
    let darkest = |x: u32, rows: std::ops::Range<u32>| rows.map(|y| pixels[(4 * (y * SIZE[0] + x) + 1) as usize]).min();
    // Of the 640, as many as a near cloud stands in.
    let closed = (0..SIZE[0]).filter(|x| darkest(*x, 50..58) >= Some(232) && darkest(*x, 72..80) >= Some(232));
    let between: Vec<u8> = closed.filter_map(|x| darkest(x, 58..72)).collect();
    let least = between.iter().min().copied().unwrap_or(0);
    println!("between white above and white below {} columns are {least} or more of 255", between.len());
    // 221 where the land hides of a closed cloud as much as it hides of the way through the layer, 224 by the mean distance of what is hidden.
    assert!(between.len() > 200 && least >= 230, "{} columns, {least}", between.len());
}

#[test]
fn what_stands_among_clouds_is_behind_the_near_ones_and_before_the_far_ones() {
    const SIZE: [u32; 2] = [640, 360];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mean = |pixels: &[u8], columns: std::ops::Range<u32>, row: u32| {
        let count = f64::from(columns.end - columns.start);
        columns.map(|x| f64::from(pixels[(4 * (row * SIZE[0] + x) + 1) as usize])).sum::<f64>() / count
    };
    // A ridge of the Alps that rises from closed clouds some kilometres ahead, and the same without them.
    let alps = |clouds: f64| format!("#view=46.3,7.2,2600,120,84&clouds={clouds}&time=2026-06-10T09:00:00Z");
    let [among, bare] = [0.5, 0.0].map(|clouds| mean(&picture(&mut renderer, &alps(clouds), SIZE), 26..62, 209));
    println!("a ridge among clouds is {:.3} times as bright as without", among / bare);
    // Clouds are brighter than what the exposure without them is for. 1.08 where clouds behind it lie over it by how much of the way is before it.
    assert!(among < 0.85 * bare, "{among} {bare}");
    // And an island behind near clouds makes no line across them.
    let gomera = "#view=28.2,-17.2,1500,90,84&clouds=0.5&time=2026-05-10T12:30:00Z";
    let pixels = picture(&mut renderer, gomera, SIZE);
    let rows: Vec<f64> = (128..150).map(|row| mean(&pixels, 140..220, row)).collect();
    let line = rows.windows(3).map(|w| (w[1] - 0.5 * (w[0] + w[2])).abs()).fold(0.0, f64::max);
    println!("rows across clouds differ from those about them by {line:.1} of 255 at most");
    // 15 by the way alone.
    assert!(line < 2.0, "{rows:?}");
}

#[test]
fn no_line_of_the_clouds_behind_it_lies_across_an_island() {
    const SIZE: [u32; 2] = [1280, 720];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // From just over the base of clouds before Moorea, which rises over the ellipsoid's horizon, in row 222.
    let link = "#view=-17.6,-149.95,905,60,80&clouds=0.4&quality=medium&time=2026-05-10T19:30:00Z";
    let pixels = picture(&mut renderer, link, SIZE);
    let row = |y: u32| -> f64 {
        (430..930).map(|x| f64::from(pixels[(4 * (y * SIZE[0] + x) + 1) as usize])).sum::<f64>() / 500.0
    };
    let lines: Vec<f64> = (216..230).map(|y| row(y) - 0.5 * (row(y - 1) + row(y + 1))).collect();
    println!("rows are {lines:.1?} of 255 brighter than those beside them");
    // 14 where pixels on the horizon had the clouds of those above it, which are behind the island, before it.
    assert!(lines.iter().all(|line| line.abs() < 6.0), "{lines:.1?}");
}

#[test]
fn no_ribbon_of_mountains_lies_across_clouds_near_the_limb() {
    const SIZE: [u32; 2] = [640, 360];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // The Alps and the Apennines under closed clouds, seen from south of Sicily.
    let pixels = picture(&mut renderer, "#view=34,18,400000,0,55&clouds=0.2&time=2026-08-02T14:00:00Z", SIZE);
    let red = |x: u32, y: u32| pixels[(4 * (y * SIZE[0] + x)) as usize];
    let mut least: Vec<f64> = (30..230)
        .map(|x| {
            let limb = (0..SIZE[1]).find(|y| red(x, *y) > 120).unwrap();
            let mut below: Vec<u8> = (limb + 4..limb + 18).map(|y| red(x, y)).collect();
            below.sort_unstable();
            f64::from(below[0]) / f64::from(below[7])
        })
        .collect();
    least.sort_by(f64::total_cmp);
    println!("below the limb columns' darkest pixel has {:.3} of their middle one, in the median", least[100]);
    // Gaps between clouds are so dark in some columns. 0.74 where what stands out of the layer hides what comes behind.
    assert!(least[100] > 0.85, "{}", least[100]);
}

#[test]
fn summits_above_the_clouds_stand_in_no_shadow() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // At 2,490 m, over slopes that stand before the sky as well.
    let mut light = |clouds: &str| {
        let link = format!("#view=47.15,11,3,10,88&time=2026-06-21T12:00:00Z&{clouds}");
        render::measure(&mut renderer, &render::parse_state(&link).unwrap(), SIZE, LayerName::Radiance).unwrap().values
    };
    let [clear, cloudy] = ["clouds=0", "clouds=0.3"].map(&mut light);
    // The lower half is ground.
    let ground = clear.len() / 2..;
    let pairs = clear[ground.clone()].chunks_exact(3).zip(cloudy[ground].chunks_exact(3));
    let lit: Vec<f64> = pairs.map(|(clear, cloudy)| cloudy[1] / clear[1]).collect();
    let least = lit.iter().fold(f64::INFINITY, |least, lit| least.min(*lit));
    println!("of the light without clouds the darkest place has {least:.3}");
    // With the shadows that clouds cast below them it has 0.204. The air before the ground is that of the eye's sky.
    assert!(lit.iter().all(|lit| lit.is_finite()) && (0.9..1.1).contains(&least), "{least}");
}
