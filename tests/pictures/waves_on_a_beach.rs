//! What a swell becomes on a straight beach, by the heights and the normals of the water as they are drawn: it turns, grows shorter and higher and
//! breaks, by the laws of waves on straight contours.

use std::f64::consts::TAU;

use glam::DVec2;
use ocean_globe::cli::render::LayerName;
use ocean_globe::model::{GRAVITY, dispersion};

use crate::battjes_janssen;
use crate::plane_beach::{Beach, View, WITHIN_DEG, taken_apart, trains_of};

/// 30 degrees off the shore's normal, and so low that its shape is a sine.
const SWELL: &str = "wind=0@90&swell=0.2,12,60";
/// One that breaks, straight in.
/// On a bed that is about as steep where they break as the usual beach is on the whole, 0.03.
const BREAKERS: &str = "wind=0@90&swell=2.2,12,90&surf=1,0.054";
/// Pixels from which phases are compared to either side: a tenth of a wave.
const REACH: usize = 14;

#[test]
fn a_swell_turns_grows_and_breaks_on_a_beach() {
    let mut beach = Beach::new("waves-on-a-beach");
    for depth_m in [5.0, 8.0] {
        let view = View { lat_deg: WITHIN_DEG, depth_m, altitude_m: 40.0, size: [80, 48] };
        turns_and_grows(&mut beach, &view);
        has_the_slopes_of_its_heights(&mut beach, &view);
    }
    breaks(&mut beach);
}

/// Ways, lengths and heights of the trains: Snell's law, the dispersion and Ks Kr.
fn turns_and_grows(beach: &mut Beach, view: &View) {
    let trains = trains_of(SWELL);
    let parts = taken_apart(&beach.heights(view, SWELL, 56), &trains);
    let ([across, down], depth_m) = (view.size, view.depth_m);
    let place = |row: usize| (across / 2 - 12..across / 2 + 12).map(move |column| row * across + column);
    let pixels: Vec<usize> = (REACH..down - REACH).flat_map(place).collect();
    let (mut angles_off, mut lengths_off, mut squares) = (Vec::new(), Vec::new(), [0.0; 2]);
    for (train, part) in trains.iter().zip(&parts) {
        // The way to the shore is to the right, south is up.
        let turned = |step: usize, sign: f64| {
            let turn = |at: usize| part[at + step].rotate(part[at - step] * DVec2::new(1.0, -1.0));
            sign * -pixels.iter().map(|&at| turn(at)).sum::<DVec2>().to_angle() / (2.0 * REACH as f64 * view.pixel_m())
        };
        let k = DVec2::new(turned(REACH, 1.0), turned(REACH * across, -1.0));
        let k_wanted = dispersion::wavenumber(train.omega, depth_m);
        let wanted = (train.omega * train.omega / GRAVITY / k_wanted * train.toward.sin()).asin();
        angles_off.push((k.to_angle() - wanted).to_degrees());
        lengths_off.push(k.length() / k_wanted - 1.0);
        let grown = dispersion::shoaling(k_wanted, depth_m) * (train.toward.cos() / wanted.cos()).sqrt();
        squares[0] += pixels.iter().map(|&at| part[at].length_squared()).sum::<f64>() / pixels.len() as f64;
        squares[1] += (train.amplitude_m * grown).powi(2);
    }
    let height = (squares[0] / squares[1]).sqrt();
    println!("{depth_m} m: {angles_off:.2?}°, {lengths_off:.3?}, rms {height:.4} of Ks Kr");
    let mean = |off: &[f64]| off.iter().sum::<f64>() / off.len() as f64;
    let most = |off: &[f64]| off.iter().map(|off| off.abs()).fold(0.0, f64::max);
    // Of a train 22 to 38 degrees off in deep water 8 to 24 are left. The grid of windows is good to 1 degree and 3 % (`shore_waves`); a single train
    // has besides what the patches keep of the swell, waves of 8 % of its height (the patches' square root of 0.006 of the energy of eight).
    // Lengths are besides as good as the phase by the bed's profile, 3.4 % (`shore_waves`).
    assert!(mean(&angles_off).abs() < 1.0 && most(&angles_off) < 5.0, "{angles_off:?} degrees");
    assert!(mean(&lengths_off).abs() < 0.05 && most(&lengths_off) < 0.14, "{lengths_off:?}");
    // All trains grow as their mean frequency does, which is right for all of them together in shallow water; cells of 2.8 m take 0.4 %, and the grid's Kr
    // is good to 3 % of each.
    assert!((height - 1.0).abs() < 0.02, "{height}");
}

/// Differences of heights against normals.
fn has_the_slopes_of_its_heights(beach: &mut Beach, view: &View) {
    let [heights, normals] = [LayerName::Height, LayerName::Normal].map(|layer| beach.layer(view, SWELL, 0.0, layer));
    let [across, down] = view.size;
    let (mut off, mut all) = (0.0, 0.0);
    for at in (8..down - 8).flat_map(|row| (8..across - 8).map(move |column| row * across + column)) {
        // East is on the left and north below; a normal leans to where the water falls.
        for (axis, step, sign) in [(0, 4, 1.0), (1, 4 * across, -1.0)] {
            let slope = sign * (heights[at + step] - heights[at - step]) / (8.0 * view.pixel_m());
            off += (slope - normals[3 * at + axis] / normals[3 * at + 2]).powi(2);
            all += slope * slope;
        }
    }
    let error = (off / all).sqrt();
    println!("{depth_m} m: normals within {error:.3} of the slopes", depth_m = view.depth_m);
    // Over 5.5 m from edge to edge a difference loses (kΔ)²/24 of the slope, 2 % of the shortest wave's; where a slope is bounded and between
    // crests, where the height has a slope of its own, the sum of trains is good to some per cent.
    assert!(error < 0.06, "{error}");
}

/// Rms heights from three times the significant height of depth to half of it.
fn breaks(beach: &mut Beach) {
    let view = View { lat_deg: WITHIN_DEG, depth_m: 2.6, altitude_m: 40.0, size: [240, 48] };
    let depths = beach.layer(&view, BREAKERS, 0.0, LayerName::Depth);
    let pictures = beach.heights(&view, BREAKERS, 48);
    let period = TAU * trains_of(BREAKERS).iter().map(|train| 1.0 / train.omega).sum::<f64>() / 8.0;
    // The mesh ends a column or two before the picture does.
    let slope = |h: f64| {
        let at = (5..230).find(|&column| depths[column] < h).unwrap_or(230);
        (depths[at - 5] - depths[at + 5]) / (10.0 * view.pixel_m())
    };
    let known = battjes_janssen::heights(slope, period, 2.2 / 2f64.sqrt());
    let of_depth = |h: f64| known.iter().find(|[depth, _]| *depth < h).unwrap_or(known.last().unwrap())[1];
    let [across, down] = view.size;
    let ratio = |column: usize| {
        let values =
            || pictures.iter().flat_map(|(_, heights)| (0..down).map(move |row| heights[row * across + column]));
        let count = (pictures.len() * down) as f64;
        let square = values().map(|height| height * height).sum::<f64>() / count;
        8.0 * square / of_depth(depths[column]).powi(2)
    };
    // Bands of 20 m, as instants are too few for each place.
    let bands: Vec<f64> =
        (0..8).map(|band| ((30 * band..30 * band + 30).map(ratio).sum::<f64>() / 30.0).sqrt()).collect();
    let error = (bands.iter().map(|band| (band - 1.0).powi(2)).sum::<f64>() / 8.0).sqrt();
    println!(
        "bed of {:.2} to {:.2} m, slopes {:.4} and {:.4}",
        depths[0],
        depths[239],
        slope(depths[1]),
        slope(depths[230])
    );
    println!("breaking: {bands:.3?} of Battjes and Janssen's heights, {error:.3} off");
    assert!(error < 0.10, "{bands:?}");
}
