//! A world about a bed of one's own: its grid where it lies, a level sea bed everywhere else.
//!
//! The grid is drawn as it is: what lies below zero is not reconciled with a mask first, as ETOPO5 must be, since one that is finer than
//! a map tile's texels has no cells of both land and sea. Where the coast and the grid disagree the coast decides, as everywhere
//! (`model::sea_bed`).

mod bed;
mod geotiff;

use std::path::Path;

use super::mask::Raster;
use super::terrain::{self, Depth, Ground};
use super::water_tile::water_tile;
use super::{About, BakeArgs, archive, resolution_m};
use crate::data::tile::{EQUATOR_M, Layer, Projection, TILE_TEXELS, TileId, lat_lon_from_map};
use crate::error::Result;
use bed::Bed;

/// Deepest level of terrain tiles that is chosen: texels of 76 m, 1/16 of them apart where the GPU's cubic needs it.
const DEEPEST: u8 = 11;

/// The bed with what is known about it everywhere.
struct Own {
    bed: Bed,
    elsewhere_m: f32,
}

/// Beyond the grid's border the ground goes over to the level bed within this, degrees.
const FADE_DEG: f64 = 0.5;

impl Ground for Own {
    fn at(&self, lat_deg: f64, lon_deg: f64, _ocean: bool) -> f32 {
        let (metres, outside_deg) = self.bed.at(lat_deg, lon_deg);
        let t = (outside_deg / FADE_DEG).min(1.0) as f32;
        metres + (self.elsewhere_m - metres) * (t * t * (3.0 - 2.0 * t))
    }

    fn is_ocean(&self, lat_deg: f64, lon_deg: f64) -> bool {
        self.at(lat_deg, lon_deg, true) < 0.0
    }

    fn step_deg(&self) -> f64 {
        self.bed.step_deg()
    }

    fn is_level(&self, lat_deg: f64, lon_deg: f64, within_deg: f64) -> bool {
        let wide_deg = (within_deg / lat_deg.to_radians().cos().max(1e-3)).min(360.0);
        let [south_north, west_east] =
            [(lat_deg, within_deg), (lon_deg, wide_deg)].map(|(at, off)| [at - off, at + off]);
        !self.bed.is_near(south_north, west_east, FADE_DEG)
    }

    fn reaches(&self, tile: TileId) -> bool {
        if tile.projection != Projection::Mercator {
            return false;
        }
        let side = f64::from(1u32 << tile.z);
        let corner = |more: f64| {
            let (lat, lon) =
                lat_lon_from_map(tile.projection, (f64::from(tile.x) + more) / side, (f64::from(tile.y) + more) / side);
            [lat.to_degrees(), lon.to_degrees()]
        };
        let ([north, west], [south, mut east]) = (corner(0.0), corner(1.0));
        if east <= west {
            east += 360.0;
        }
        self.bed.is_near([south, north], [west, east], FADE_DEG)
    }
}

/// Terrain of the whole world and the poles' water; the other water is that of the polygons.
///
/// # Errors
/// A bed that is missing, damaged or of another kind than [`Bed::open`] takes.
pub fn bake(args: &BakeArgs, path: &Path) -> Result<()> {
    let own = Own { bed: Bed::open(path)?, elsewhere_m: args.bed_elsewhere_m };
    let cos_lat = own.bed.middle_lat_deg().to_radians().cos();
    let step_m = resolution_m(own.bed.step_deg()) * cos_lat;
    let levels = (EQUATOR_M * cos_lat / TILE_TEXELS as f64 / step_m.max(1.0)).log2().ceil().max(0.0);
    let deepest = args.bed_zoom.unwrap_or((levels as u8).min(DEEPEST));
    for projection in Projection::ALL {
        let max_zoom = if projection == Projection::Mercator { deepest } else { 0 };
        let depth = Depth { max_zoom, full_zoom: max_zoom, worth_m: 0.0 };
        let about = About {
            layer: Layer::Terrain,
            projection,
            encoding: "terrarium",
            credit: &args.elevation_credit,
            resolution_m: resolution_m(own.bed.step_deg()),
        };
        archive(&args.output, &about, |writer, progress| {
            terrain::add_tiles(writer, projection, &own, &depth, progress)
        })?;
        if projection != Projection::Mercator {
            let about = About {
                layer: Layer::Water,
                projection,
                encoding: "ocean-globe-water",
                credit: "",
                resolution_m: about.resolution_m,
            };
            let root = TileId::root(projection);
            archive(&args.output, &about, |writer, _| {
                writer.add(root.z, root.x, root.y, &water_tile(root, &Raster::of_ocean())?.bytes)
            })?;
        }
    }
    Ok(())
}
