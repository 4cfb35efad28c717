//! The drawn land's albedo: that of the imagery's tiles in the mean, without seams, the same from wherever it is seen.

use std::collections::HashMap;
use std::path::Path;

use ocean_globe::cli::render::{self, LayerName, Measured};
use ocean_globe::data::fetch::Source;
use ocean_globe::data::imagery;
use ocean_globe::data::pmtiles::Archive;
use ocean_globe::data::tile::{Layer, MapPoint, Projection, TILE_TEXELS, TileId, texels_across};
use ocean_globe::data::world::archive_name;
use ocean_globe::renderer::{Radiance, Renderer};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

fn renderer() -> Renderer {
    render::headless(DATA, Radiance::Single).unwrap()
}

fn measured(renderer: &mut Renderer, fragment: &str, size: [u32; 2], layer: LayerName) -> Measured {
    render::measure(renderer, &render::parse_state(fragment).unwrap(), size, layer).unwrap()
}

/// Albedo of each pixel of a view with its longitude and latitude, degrees; both NaN in the sky.
fn albedo(renderer: &mut Renderer, fragment: &str, size: [u32; 2]) -> Vec<([f64; 2], [f64; 3])> {
    let [albedo, lonlat] =
        [LayerName::Albedo, LayerName::Lonlat].map(|layer| measured(renderer, fragment, size, layer));
    let places = lonlat.values.as_chunks().0.iter().copied();
    places.zip(albedo.values.as_chunks().0.iter().copied()).collect()
}

fn mean(albedo: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    let (sum, count) = albedo.fold(([0.0; 3], 0), |(sum, count), texel| {
        ([sum[0] + texel[0], sum[1] + texel[1], sum[2] + texel[2]], count + 1)
    });
    sum.map(|part| part / f64::from(count))
}

/// One bundled archive, decoded.
struct Tiles {
    archive: Archive<Source>,
    decoded: HashMap<TileId, Option<Vec<[u8; 4]>>>,
}

impl Tiles {
    fn open(projection: Projection) -> Self {
        let path = Path::new(DATA).join(archive_name(Layer::Imagery, projection));
        let archive = pollster::block_on(Archive::open(Source::new(path.to_str().unwrap()))).unwrap();
        Self { archive, decoded: HashMap::new() }
    }

    fn tile(&mut self, id: TileId) -> Option<&[[u8; 4]]> {
        let archive = &self.archive;
        let decode = |bytes: Vec<u8>| imagery::decode(&id.to_string(), &bytes).unwrap();
        let tile = || pollster::block_on(archive.tile(id.z, id.x, id.y)).unwrap().map(decode);
        self.decoded.entry(id).or_insert_with(tile).as_deref()
    }

    /// Albedo that a place's tiles say: linear light of the finest tile there, bilinear, through the curve of `shaders/lib/imagery.wgsl`.
    fn albedo(&mut self, lat_deg: f64, lon_deg: f64) -> [f64; 3] {
        let point = MapPoint::from_lat_lon(lat_deg.to_radians(), lon_deg.to_radians());
        let z = (0..=self.archive.header().max_zoom).rev().find(|z| self.tile(point.tile(*z)).is_some()).unwrap();
        let [x, y] = [point.u, point.v].map(|at| f64::from(at) / 4_294_967_296.0 * texels_across(z) - 0.5);
        let mut sum = [0.0; 3];
        for (i, j) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let (column, row) = (x.floor() + i, y.floor() + j);
            let weight = (1.0 - (x - column).abs()) * (1.0 - (y - row).abs());
            let side = TILE_TEXELS as f64;
            let id = TileId { x: (column / side) as u32, y: (row / side) as u32, z, ..point.tile(z) };
            let at = (row % side) as usize * TILE_TEXELS + (column % side) as usize;
            let texel = self.tile(id).map_or([0; 4], |texels| texels[at]);
            sum.iter_mut().zip(texel).for_each(|(sum, byte)| *sum += weight * linear(byte));
        }
        std::array::from_fn(|part| 0.76 * sum[part].powf(0.8) + [0.014, 0.022, 0.009][part])
    }
}

/// Linear light of an sRGB byte (IEC 61966-2-1).
fn linear(byte: u8) -> f64 {
    let value = f64::from(byte) / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

#[test]
fn the_drawn_albedo_has_the_mean_of_the_tiles_detail_or_not() {
    let mut renderer = renderer();
    let mut tiles = Tiles::open(Projection::Mercator);
    // Desert, rain forest, fields, mountains with snow, steppe, ice: level enough that no rock shows.
    for (lat, lon) in [(23.0, 10.0), (-5.0, -65.0), (49.0, 31.0), (-47.0, -69.0), (48.0, 68.0), (73.0, -40.0)] {
        for quality in ["medium", "low"] {
            // 60 km across, hence some 150 of the detail's largest cells, whose mean is within a hundredth.
            let view = format!("#view={lat},{lon},60000,0,0&quality={quality}&time=2026-06-21T12:00:00Z");
            let pixels = albedo(&mut renderer, &view, [160, 160]);
            let drawn = mean(pixels.iter().map(|(_, albedo)| *albedo));
            let of_tiles = mean(pixels.iter().map(|([lon, lat], _)| tiles.albedo(*lat, *lon)));
            let off: Vec<f64> = drawn.iter().zip(of_tiles).map(|(drawn, tiles)| (drawn / tiles - 1.0).abs()).collect();
            println!("{lat}, {lon}, {quality}: {of_tiles:.3?}, off by {off:.4?}");
            assert!(off.iter().all(|off| *off < 0.02), "{lat}, {lon}, {quality}: {drawn:?} against {of_tiles:?}");
            let spread = pixels.iter().map(|(_, albedo)| (albedo[1] - drawn[1]).abs()).sum::<f64>() / 25_600.0;
            assert!(quality == "low" || spread > 0.002, "{lat}, {lon}: detail should show, {spread}");
        }
    }
}

#[test]
fn snow_lies_on_the_heights_and_as_much_of_it_as_the_tiles_have() {
    let mut renderer = renderer();
    let mut tiles = Tiles::open(Projection::Mercator);
    let places = [(61.5, 8.3), (62.3, 9.0), (60.8, 7.5), (66.8, 15.5), (68.2, 18.5), (46.5, 8.3), (59.8, 7.2)];
    let (mut drawn, mut of_tiles) = (Vec::new(), Vec::new());
    for (lat, lon) in places {
        let view = format!("#view={lat},{lon},20000,0,0&quality=medium&time=2026-06-21T12:00:00Z");
        let pixels = albedo(&mut renderer, &view, [160, 160]);
        let height = measured(&mut renderer, &view, [160, 160], LayerName::Height).values;
        let mut by_height: Vec<_> =
            pixels.iter().zip(height).map(|((_, albedo), height)| (height, albedo[2])).collect();
        by_height.sort_by(|a, b| a.0.total_cmp(&b.0));
        let fifth = by_height.len() / 5;
        let blue = |part: &[(f64, f64)]| part.iter().map(|(_, blue)| blue).sum::<f64>() / fifth as f64;
        let [low, high] = [blue(&by_height[..fifth]), blue(&by_height[4 * fifth..])];
        println!("{lat}, {lon}: {low:.3} of the lowest fifth, {high:.3} of the highest");
        assert!(high > 2.0 * low, "{lat}, {lon}: {low} and {high}");
        drawn.extend(pixels.iter().map(|(_, albedo)| *albedo));
        of_tiles.extend(pixels.iter().map(|([lon, lat], _)| tiles.albedo(*lat, *lon)));
    }
    // A place of 16 km has a few summits, so that its mean is off by a tenth either way, that of seven by a 26th; rock hides 2 %.
    let [drawn, of_tiles] = [drawn, of_tiles].map(|all| mean(all.into_iter()));
    println!("{drawn:.3?} for {of_tiles:.3?}");
    assert!(
        drawn.iter().zip(of_tiles).all(|(drawn, tiles)| (drawn / tiles - 1.0).abs() < 0.06),
        "{drawn:?} {of_tiles:?}"
    );
}

/// How far the albedo of neighbours differs from a straight line at most: a seam is a step, and shows as it is.
fn roughest(pixels: &[([f64; 2], [f64; 3])], width: usize) -> f64 {
    let bent = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        (0..3).map(|part| (a[part] - 2.0 * b[part] + c[part]).abs()).fold(0.0, f64::max)
    };
    let row = |at: usize| bent(pixels[at - 1].1, pixels[at].1, pixels[at + 1].1);
    let column = |at: usize| bent(pixels[at - width].1, pixels[at].1, pixels[at + width].1);
    let inside = (width..pixels.len() - width).filter(|at| !matches!(at % width, 0) && at % width != width - 1);
    inside.map(|at| row(at).max(column(at))).fold(0.0, f64::max)
}

#[test]
fn no_seam_shows_at_the_borders_of_tiles() {
    let mut renderer = renderer();
    // Where two to four tiles of level 5 and of all levels above meet, across the antimeridian, and where a tile of level 5 ends beside one of
    // level 4: in Saskatchewan, Siberia (three times) and on the Pechora.
    let alike = [(48.922_499, 11.25), (0.0, 22.5), (40.979_898, 90.0), (66.7, 180.0), (21.943_046, 0.0)];
    let unlike = [(52.5, -101.25), (58.8, 67.5), (58.8, 90.0), (72.4, 101.25), (64.2, 56.25)];
    let places = alike.map(|place| (place, 0.001)).into_iter().chain(unlike.map(|place| (place, 0.05)));
    for ((lat, lon), bound) in places {
        let view = format!("#view={lat},{lon},40000,0,0&quality=low&time=2026-06-21T12:00:00Z");
        let pixels = albedo(&mut renderer, &view, [240, 240]);
        // The spline bends by no more than what neighbouring texels differ by over the square of the 20 pixels or more between them: 0.4 of
        // albedo, snow beside rock, makes 0.001. A seam of one step of 255 is 0.001 in dark ground and 0.005 in bright.
        // Tiles that differ from their parents' picture by less than 0.8 steps in the mean were left out: some texel of a border by two, which
        // are a twentieth of the light of dark ground.
        let unit = if bound < 0.01 { 1.0 } else { mean(pixels.iter().map(|(_, albedo)| *albedo))[1] };
        let roughest = roughest(&pixels, 240) / unit;
        println!("{lat}, {lon}: {roughest:.5}");
        assert!(roughest < bound, "{lat}, {lon}: {roughest}");
    }
}

#[test]
fn a_place_has_one_albedo_from_wherever_it_is_seen() {
    let mut renderer = renderer();
    let time = "quality=low&time=2026-06-21T12:00:00Z";
    for (lat, lon) in [(28.0, 2.0), (46.0, 9.0), (-33.0, 149.0), (-84.2, 60.0)] {
        let views = [
            format!("#view={lat},{lon},20000,0,0&{time}"),
            format!("#view={},{},45000,120,35&{time}", lat + 0.25, lon - 0.4),
        ];
        let size = [200, 200];
        let [first, second] = views.map(|view| albedo(&mut renderer, &view, size));
        let (mut worst, mut compared) = (0.0f64, 0);
        // The first view looks straight down, north up: columns are longitudes and rows latitudes, nearly.
        let middle =
            |at: usize, part: usize| if part == 0 { first[100 * 200 + at].0[0] } else { first[at * 200 + 100].0[1] };
        let guess = |part: usize, degrees: f64| {
            let (from, to) = (middle(0, part), middle(199, part));
            ((degrees - from) / (to - from) * 199.0).round() as i64
        };
        for ([lon, lat], albedo) in second.iter().filter(|([lon, _], _)| lon.is_finite()).step_by(7) {
            let away = |place: &[f64; 2]| {
                let turned = (place[0] - lon + 180.0).rem_euclid(360.0) - 180.0;
                (turned * lat.to_radians().cos()).hypot(place[1] - lat)
            };
            let around = |at: i64| (at - 4).max(0)..(at + 5).min(200);
            let rows =
                around(guess(1, *lat)).flat_map(|row| around(guess(0, *lon)).map(move |column| row * 200 + column));
            let near = rows.map(|at| &first[at as usize]).min_by(|(a, _), (b, _)| away(a).total_cmp(&away(b)));
            let Some(near) = near else { continue };
            // Pixels of the first view are 83 m apart.
            if away(&near.0) * 111_000.0 > 60.0 {
                continue;
            }
            compared += 1;
            worst = albedo.iter().zip(near.1).map(|(a, b)| (a - b).abs()).fold(worst, f64::max);
        }
        println!("{lat}, {lon}: {compared} places, {worst:.4} at most");
        assert!(compared > 100, "{lat}, {lon}: only {compared} places");
        // 60 m are 1/40 of a texel there or less; neighbours differ by 0.4 at most, snow beside rock.
        assert!(worst < 0.012, "{lat}, {lon}: {worst}");
    }
}
