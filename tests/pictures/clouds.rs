//! Clouds in pictures: what they hide, what they shade, and how they are left out.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Output;

pub const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

pub fn picture(renderer: &mut Renderer, link: &str, size: [u32; 2]) -> Vec<u8> {
    let state = render::parse_state(link).unwrap();
    render::picture(renderer, &state, size).unwrap()
}

/// Mean of red, green and blue over rows of a picture.
fn mean(pixels: &[u8], width: usize, rows: std::ops::Range<usize>) -> [f64; 3] {
    let part = &pixels[4 * width * rows.start..4 * width * rows.end];
    std::array::from_fn(|i| {
        part.iter().skip(i).step_by(4).map(|v| f64::from(*v)).sum::<f64>() / (part.len() / 4) as f64
    })
}

pub const SIZE: [u32; 2] = [160, 90];
const DECK: &str = "#view=35,-30,4,0,84&wind=6@250&quality=low&time=2026-06-21T14:00:00Z";

#[test]
fn clouds_can_be_taken_away() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    for view in [&DECK.replace("-30", "-42"), "#view=10,-30,9000000&quality=low&time=2026-06-21T14:00:00Z"] {
        let mut of = |clouds: &str| picture(&mut renderer, &format!("{view}{clouds}"), SIZE);
        let [clear, cloudy, hidden] = ["&clouds=0", "&clouds=0.6", "&clouds=0.6&layers=-clouds"].map(&mut of);
        let changed =
            clear.chunks_exact(4).zip(cloudy.chunks_exact(4)).filter(|(a, b)| a[0].abs_diff(b[0]) > 8).count();
        println!("clouds change {changed} of {} pixels", clear.len() / 4);
        assert!(changed * 10 > clear.len() / 4 && clear == hidden);
    }
}

#[test]
fn an_overcast_sky_is_grey_and_so_is_the_sea_below_it() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut of = |clouds: &str| {
        let pixels = picture(&mut renderer, &format!("{DECK}{clouds}"), SIZE);
        [mean(&pixels, 160, 0..20), mean(&pixels, 160, 60..90)]
    };
    let [[clear_sky, clear_sea], [grey_sky, grey_sea]] = ["&clouds=0", "&clouds=1"].map(&mut of);
    let blueness = |[r, _, b]: [f64; 3]| (b - r) / b;
    println!("sky {clear_sky:.0?} and overcast {grey_sky:.0?}, sea {clear_sea:.0?} and {grey_sea:.0?}");
    assert!(blueness(clear_sky) > 0.3 && blueness(grey_sky) < 0.15, "{clear_sky:?} {grey_sky:?}");
    assert!(blueness(grey_sea) < 0.5 * blueness(clear_sea), "{clear_sea:?} {grey_sea:?}");
}

/// Mean luminance of the sky with its clouds about the sine `rise`, before it is exposed.
fn sky_at(renderer: &mut Renderer, heading: i32, rise: f64) -> f64 {
    let tilt = 90.0 + rise.asin().to_degrees();
    let view = format!("#view=35,-30,4,{heading},{tilt}&clouds=1&time=2026-06-21T14:00:00Z");
    let state = render::parse_state(&view).unwrap();
    let (frame, _) = render::draw(renderer, &state, SIZE, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    // The rows about the middle.
    let green = bytes.chunks_exact(8).skip(43 * 160).take(4 * 160);
    let of = |texel: &[u8]| half::f16::from_le_bytes([texel[2], texel[3]]).to_f64();
    green.map(of).sum::<f64>() / 640.0 / f64::from(frame.uniform.exposure)
}

#[test]
fn an_overcast_sky_is_darker_towards_the_horizon() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // Away from the sun's side as much as towards it, since clouds are brighter there.
    let mut of = |rise| (0..6).map(|i| sky_at(&mut renderer, 60 * i, rise)).sum::<f64>() / 6.0;
    let [low, high] = [0.2, 0.9].map(&mut of);
    println!("an overcast sky has {low:.4} at a sine of .2 and {high:.4} at .9: 1 to {:.2}", high / low);
    // Before 0.60. Eddington's 2 + 3 sine: 1.81; the CIE's overcast sky, 1 + 2 sine: 2.00. Between heaps there are holes, which are bright, and haze.
    assert!((1.05..2.0).contains(&(high / low)), "{low} {high}");
}

#[test]
fn heaps_are_grey_below_and_white_about_their_edges() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // Under a sun near its zenith.
    let state =
        render::parse_state("#view=18,-60,3,250,96&clouds=0.35&quality=high&time=2026-06-21T17:00:00Z").unwrap();
    let (frame, _) = render::draw(&mut renderer, &state, [320, 180], Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let of = |texel: &[u8], at: usize| half::f16::from_le_bytes([texel[2 * at], texel[2 * at + 1]]).to_f64();
    let sky = bytes.chunks_exact(8).take(320 * 120);
    let white = std::f64::consts::PI / f64::from(frame.uniform.exposure);
    let is_cloud = |texel: &&[u8]| of(texel, 2) < 1.3 * of(texel, 0);
    let mut green: Vec<_> = sky.filter(is_cloud).map(|texel| white * of(texel, 1)).collect();
    green.sort_by(f64::total_cmp);
    let [dark, bright] = [0.1, 0.9].map(|share| green[(share * green.len() as f64) as usize]);
    println!("{} pixels of clouds have {dark:.2} and {bright:.2} of the brightness of white ground", green.len());
    // Edges of heaps that stand before the blue are as narrow as pixels: the steepest steps are a fifth of what lies between white heaps and the blue,
    // 0.5 of red light. Soft edges have 0.074.
    let rows = bytes.chunks_exact(8 * 320).take(120);
    let change = |pair: &[u8]| white * (of(&pair[8..], 0) - of(pair, 0)).abs();
    let mut steps: Vec<f64> = rows.flat_map(|row| row.windows(16).step_by(8).map(change)).collect();
    steps.sort_by(f64::total_cmp);
    let edge = steps[steps.len() * 98 / 100];
    println!("one of fifty pixels differs from the one beside it by more than {edge:.3}");
    assert!(edge > 0.1, "{edge}");
    // Two streams: a heap 700 m deep with 0.05 of optical depth a metre, of which 0.15 do not go on ahead, lets 0.20 of the nine tenths of
    // sunlight through that reach it. Its sides reflect what is left of three quarters, on average half of it sideways.
    assert!(green.len() > 3000 && (0.1..0.2).contains(&dark) && (0.5..0.85).contains(&bright), "{dark} {bright}");
}

#[test]
fn spray_stands_before_clouds() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut step = |grade: u32| {
        let link = format!("#view=35.7,-14.3,12,262,90&clouds=0.6&bft={grade}&time=2026-11-20T12:00:00Z");
        let pixels = picture(&mut renderer, &link, SIZE);
        // The horizon lies across the middle.
        let [above, below] = [41..44, 47..50].map(|rows| mean(&pixels, 160, rows)[1]);
        (above - below).abs()
    };
    let [gale, hurricane] = [8, 12].map(&mut step);
    println!("across the horizon the picture changes by {gale:.1} of 255 in a gale and {hurricane:.1} in a hurricane");
    // Where one sees less than a kilometre there is no horizon: spray hides nearly all of the sky there, and of the sea below it all but what is near.
    assert!(hurricane < 0.3 * gale, "{gale} {hurricane}");
}

#[test]
fn spray_before_a_far_sea_has_one_colour_under_broken_clouds() {
    const SIZE: [u32; 2] = [320, 180];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let link = "#view=25,140,20,262,86&bft=12&time=2026-08-20T03:00:00Z";
    let pixels = picture(&mut renderer, link, SIZE);
    // Some pixels below the horizon, which stands 15 over the middle: one sees 600 m there, so nearly all of it is spray.
    let blueness = |column: usize| {
        let at = (80..83).flat_map(|y| (column..column + 16).map(move |x| 4 * (320 * y + x)));
        let [red, blue] =
            at.fold([0.0, 0.0], |sum, at| [sum[0] + f64::from(pixels[at]), sum[1] + f64::from(pixels[at + 2])]);
        blue / red
    };
    let ratios: Vec<f64> = (0..20).map(|column| blueness(16 * column)).collect();
    let [least, most] = [ratios.iter().copied().fold(f64::MAX, f64::min), ratios.iter().copied().fold(0.0, f64::max)];
    println!("blue over red of the far spray: {least:.3} to {most:.3}");
    // Lit by the sky over what it hides it was blue below the gaps there, by a tenth; a hundredth of what lies behind shows.
    assert!(most - least < 0.05, "{ratios:.3?}");
}

#[test]
fn clouds_cast_shadows() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut ratios = Vec::new();
    for place in 0..48 {
        // The Sahara from 300 m, straight down, at noon: as wide as several weathers.
        let (lat, lon) = (20.0 + 1.1 * f64::from(place % 8), -4.0 + 5.0 * f64::from(place / 8));
        let mut of = |clouds| {
            let link = format!("#view={lat},{lon},300,0,0&quality=low&time=2026-06-21T11:40:00Z&clouds={clouds}");
            let state = render::parse_state(&link).unwrap();
            let values = render::measure(&mut renderer, &state, [4, 4], LayerName::Radiance).unwrap().values;
            values.iter().sum::<f64>()
        };
        ratios.push(of(0.6) / of(0.0));
    }
    ratios.sort_by(f64::total_cmp);
    println!("in shadow {:.2}, in the sun {:.2} of a clear day's light", ratios[2], ratios[45]);
    // Deep shadows have a fifth to a half of the light; beside clouds there is up to a fifth more, from them.
    assert!((0.2..0.5).contains(&ratios[2]) && (0.85..1.25).contains(&ratios[45]), "{ratios:.2?}");
}

/// Green light of a picture of a state: its rows from top to bottom.
pub fn green_light(renderer: &mut Renderer, link: &str, size: [u32; 2]) -> Vec<f64> {
    let state = render::parse_state(link).unwrap();
    let _ = render::draw(renderer, &state, size, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    bytes.chunks_exact(8).map(|texel| half::f16::from_le_bytes([texel[2], texel[3]]).to_f64()).collect()
}

#[test]
fn far_clouds_are_no_pinker_than_near_ones() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // Over closed clouds by day, which end at the horizon a fifth of the picture below its top.
    let link = "#view=-20,-110,3000,330,75&bft=4&clouds=0.55&time=2026-05-04T15:30Z&quality=high";
    let pixels = picture(&mut renderer, link, SIZE);
    let redness = |rows| {
        let [red, _, blue] = mean(&pixels, 160, rows);
        red - blue
    };
    let far = (17..26).map(|row| redness(row..row + 1)).fold(f64::MIN, f64::max);
    let near = redness(75..90);
    println!("red is over blue by {far:.1} of 255 where clouds end, and by {near:.1} near the eye");
    // Two of 255 are as little as is seen between neighbours. Where the air took blue from what is far, and gave none of it back, it was five.
    assert!(far < near + 2.0, "{far} {near}");
}

#[test]
fn overcast_skies_have_shades() {
    const SIZE: [u32; 2] = [160, 90];
    /// Pixels: at 30 degrees over the horizon some 60 m, as wide as lobes of clouds are.
    const APART: usize = 4;
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let mut contrast = Vec::new();
    for lon in [-75, -60, -45, 75] {
        let hour = 14 - lon / 15;
        let link = format!("#view=-30,{lon},5,0,120&clouds=0.95&quality=high&time=2026-05-01T{hour:02}:00:00Z");
        let green = green_light(&mut renderer, &link, SIZE);
        let rows = green.chunks_exact(SIZE[0] as usize);
        let apart = rows.flat_map(|row| row.windows(APART + 1).map(|pair| (pair[APART] / pair[0]).ln().abs()));
        let mut apart: Vec<_> = apart.collect();
        apart.sort_by(f64::total_cmp);
        contrast.push(apart[apart.len() / 2]);
    }
    let mean = contrast.iter().sum::<f64>() / contrast.len() as f64;
    println!("places of closed clouds {APART} pixels apart differ by {contrast:.4?}, {mean:.4} on average");
    // Where no sight knew more of a cloud than that it had met one, it was 0.0129.
    assert!((0.018..0.06).contains(&mean), "{contrast:?}");
}

#[test]
fn the_far_sea_ends_in_the_haze_that_the_sky_under_clouds_starts_in() {
    const SIZE: [u32; 2] = [160, 360];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    for view in [
        "58.9,5.4,300,250,80&bft=8&clouds=0.5&time=2026-10-03T12:00:00Z",
        "40,-40,200,160,80&bft=5&clouds=0.7&time=2026-03-03T10:00:00Z",
    ] {
        let pixels = picture(&mut renderer, &format!("#view={view}"), SIZE);
        // The horizon stands 10 degrees less its dip over the picture's middle.
        let altitude_m: f64 = view.split(',').nth(2).unwrap().parse().unwrap();
        let over = 10f64.to_radians() - (2.0 * altitude_m / 6.371e6).sqrt();
        let horizon = (180.0 * (1.0 - over.tan() / 22.5f64.to_radians().tan())) as usize;
        for part in 0..4 {
            let row = |y: usize| {
                let first = 4 * (y * 160 + 40 * part) + 1;
                pixels[first..].iter().step_by(4).take(40).map(|green| f64::from(*green)).sum::<f64>() / 40.0
            };
            let rows: Vec<f64> = (horizon - 5..horizon + 5).map(row).collect();
            let step = rows.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
            println!("{view} {part}: {rows:.0?}");
            // Over the horizon the air fades over some 20 rows; a sea in another light than the sky's ends in a step of a tenth.
            assert!(step < 6.0, "{view}, part {part}: {step} of 255 from row to row in {rows:?}");
        }
    }
}

#[test]
fn an_eye_among_clouds_sees_those_behind_the_ones_about_it() {
    const SIZE: [u32; 2] = [320, 180];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let link = "#view=-16.5,-151.75,1500,30,70&bft=5&clouds=0.3&time=2026-08-03T22:00:00Z";
    let pixels = picture(&mut renderer, link, SIZE);
    // From 1 to 5 degrees below the horizontal a sight is 7 to 34 km in the layer: at three tenths of cover it meets a cloud all but always, the more
    // so as clouds are as high as they are wide.
    let rows = &pixels[4 * 320 * 10..4 * 320 * 24];
    let white = rows.chunks_exact(4).filter(|pixel| i32::from(pixel[2]) - i32::from(pixel[0]) < 15).count();
    let share = white as f64 / (rows.len() / 4) as f64;
    println!("clouds over {share:.2} of the rows");
    assert!(share > 0.85, "{share}");
}

/// How many times as bright a sky of so many clouds is beside the sun, as nine degrees from it.
fn glow_about_the_sun(renderer: &mut Renderer, clouds: f64) -> f64 {
    const SIZE: [u32; 2] = [320, 180];
    let link = format!("#view=10,-110,5,270,95&bft=3&clouds={clouds}&time=2026-05-13T00:40:00Z");
    let (frame, _) = render::draw(renderer, &render::parse_state(&link).unwrap(), SIZE, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let u = &frame.uniform;
    // Means of what stands so many degrees from the sun, over the sea.
    let [near, far] = [1.0..2.0, 8.0..10.0].map(|ring: std::ops::Range<f32>| {
        let (mut sum, mut count) = (0.0, 0.0);
        for (pixel, texel) in bytes.chunks_exact(8).enumerate() {
            let [x, y] = [pixel as u32 % SIZE[0], pixel as u32 / SIZE[0]].map(|at| at as f32 + 0.5);
            let right = (2.0 * x / SIZE[0] as f32 - 1.0) * u.ray_right;
            let ray = (u.ray_forward + right + (1.0 - 2.0 * y / SIZE[1] as f32) * u.ray_up).normalize();
            if ray.z > 0.01 && ring.contains(&ray.angle_between(u.sun).to_degrees()) {
                sum += half::f16::from_le_bytes([texel[2], texel[3]]).to_f64();
                count += 1.0;
            }
        }
        sum / count
    });
    println!("clouds {clouds}: {:.1} times as bright beside the sun as nine degrees from it", near / far);
    near / far
}

#[test]
fn thin_clouds_before_the_sun_glow_about_it_and_closed_ones_hide_it() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let [thin, closed] = [0.3, 0.5].map(|clouds| glow_about_the_sun(&mut renderer, clouds));
    // Clouds that scatter evenly are 1.6 and 1.1 times so.
    assert!(thin > 5.0 && closed < 2.0, "{thin} {closed}");
}

/// Of a dawn over an overcast sea: means of the sky's rows by the horizon and high above it, and the most that a pixel of the sea is redder than
/// blue, of 255.
fn overcast_dawn(renderer: &mut Renderer, time: &str) -> ([f64; 3], [f64; 3], i32) {
    let link = format!("#view=35.6812,-14.25,4,113,90&bft=3&clouds=0.95&quality=high&time=2026-11-20T{time}Z");
    let pixels = picture(renderer, &link, [320, 180]);
    // The horizon is in the row below the middle, where crests of grade 3 stand no higher than two.
    let redder = pixels[4 * 320 * 100..].chunks_exact(4).map(|p| i32::from(p[0]) - i32::from(p[2])).max();
    (mean(&pixels, 320, 80..87), mean(&pixels, 320, 10..20), redder.unwrap())
}

#[test]
fn a_sea_under_closed_clouds_has_no_glints_of_a_sun_that_has_not_risen() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    for time in ["07:15:00", "07:36:00"] {
        let (low, high, redder) = overcast_dawn(&mut renderer, time);
        println!("{time}: sky {low:.0?} at the horizon, {high:.0?} above; the sea's reddest pixel by {redder}");
        // Of grey light none is redder than blue. An overcast sky's horizon has half of what its zenith has, and more where haze is before it;
        // display values go about with the square root.
        assert!(redder < 4, "{redder}");
        assert!(low[1] > 0.6 * high[1], "{low:?} {high:?}");
    }
}

#[test]
fn the_sea_mirrors_clouds_that_the_rising_sun_shines_on_from_below() {
    const SIZE: [u32; 2] = [160, 90];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    // Away from the sun; the horizon is in the upper half.
    let link = "#view=47,-20,15,240,84&bft=4&clouds=0.6&time=2026-06-21T05:30:00Z&quality=high&layers=-foam";
    let state = render::parse_state(link).unwrap();
    let _ = render::draw(&mut renderer, &state, SIZE, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let part = |texel: &[u8], at: usize| half::f16::from_le_bytes([texel[2 * at], texel[2 * at + 1]]).to_f64();
    // Red over blue of a band of rows.
    let hue = |rows: std::ops::Range<usize>| {
        let band = bytes.chunks_exact(8).skip(rows.start * SIZE[0] as usize).take(rows.len() * SIZE[0] as usize);
        let [red, blue] = band.fold([0.0; 2], |[red, blue], texel| [red + part(texel, 0), blue + part(texel, 2)]);
        red / blue
    };
    let [sky, sea] = [hue(0..24), hue(38..60)];
    println!("red over blue {sky:.3} in the sky, {sea:.3} in the sea under it");
    // Rough water mirrors the sky as high as this; a sixth of the light is that from within the water, which has no red, and a fifth of what it
    // mirrors the blue haze before the clouds.
    assert!(sea > 0.66 * sky, "{sea} {sky}");
}

/// Steps in a cloud that are wider than its wisps find other ones in each of four neighbouring pixels: its edges were combed, four to five pixels from tooth to tooth.
#[test]
fn clouds_have_no_teeth() {
    const SIZE: [u32; 2] = [1280, 720];
    const ROWS: usize = 180;
    const COLUMNS: std::ops::Range<usize> = 500..1268;
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let link = "#view=52.372,4.5223,12,330,80&wind=9@300&clouds=0.35&layers=-sea,-land&time=2026-07-20T18:45:00Z";
    let pixels = picture(&mut renderer, link, SIZE);
    let count = COLUMNS.len();
    let plan = rustfft::FftPlanner::new().plan_fft_forward(count);
    let mut power = vec![0.0; count];
    for row in pixels.chunks_exact(4 * SIZE[0] as usize).take(ROWS) {
        let luminance = |c: &[u8]| 0.2126 * f64::from(c[0]) + 0.7152 * f64::from(c[1]) + 0.0722 * f64::from(c[2]);
        let values: Vec<f64> = row.chunks_exact(4).map(luminance).skip(COLUMNS.start).take(count).collect();
        let mean = values.iter().sum::<f64>() / count as f64;
        let window = |i: usize| 0.5 - 0.5 * (std::f64::consts::TAU * i as f64 / count as f64).cos();
        let mut row: Vec<_> =
            (0..count).map(|i| rustfft::num_complex::Complex::new((values[i] - mean) * window(i), 0.0)).collect();
        plan.process(&mut row);
        power.iter_mut().zip(&row).for_each(|(sum, value)| *sum += value.norm_sqr());
    }
    // Cycles over a pixel.
    let between = |from: f64, to: f64| {
        let band = &power[(from * count as f64) as usize..(to * count as f64) as usize];
        band.iter().sum::<f64>() / band.len() as f64
    };
    let ratio = between(0.2, 0.24) / between(0.32, 0.34);
    println!("power at 4.5 pixels over that at 3: {ratio:.2}");
    // That of soft edges falls with the fourth power of the frequency, by 5.1 from one to the other, and by chance some tenths more or less; teeth made
    // it 8.4. An empty sky's noise has all frequencies alike.
    assert!((3.0..6.5).contains(&ratio), "power at 4.5 pixels over that at 3 is {ratio}");
}
