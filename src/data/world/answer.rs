//! From an archive to a tile: which of its tiles tells of it, and what that one's bytes say.

use super::{DEEPEST_SHORES, Decoded, Key};
use crate::data::coast::inland::Inland;
use crate::data::fetch::Source;
use crate::data::pmtiles::Archive;
use crate::data::tile::{Layer, Projection, TileId};
use crate::data::{TileTexels, coast, imagery, terrarium, water};
use crate::error::Result;
use std::sync::Arc;

/// Deepest level of the tiles that an archive gives.
pub(super) fn deepest(archive: &Archive<Source>) -> u8 {
    let header = archive.header();
    if header.tile_type == coast::TILE_TYPE { header.max_zoom.max(DEEPEST_SHORES) } else { header.max_zoom }
}

/// The tile of the archive that tells of a tile: itself, or where the archive ends its ancestor.
pub(super) fn stored(archive: &Archive<Source>, id: TileId) -> TileId {
    id.ancestor(archive.header().max_zoom).unwrap_or(id)
}

pub(super) async fn load(archive: &Archive<Source>, key: Key) -> Result<Option<Decoded>> {
    let stored = stored(archive, key.1);
    let Some(bytes) = archive.tile(stored.z, stored.x, stored.y).await? else { return Ok(None) };
    decoded(archive, key, &bytes)
}

/// What the bytes of a tile say of it; `None` where its shores are too far to be told at its level, so that its parent serves.
pub(super) fn decoded(archive: &Archive<Source>, (layer, id): Key, bytes: &[u8]) -> Result<Option<Decoded>> {
    let what = format!("{} tile {id}", layer.name());
    let texels = match layer {
        Layer::Terrain => {
            let mapbox = archive.metadata().get("encoding").is_some_and(|e| e == "mapbox");
            let encoding = if mapbox { terrarium::Encoding::Mapbox } else { terrarium::Encoding::Terrarium };
            TileTexels::Terrain(terrarium::decode(&what, bytes, encoding)?)
        }
        Layer::Water if archive.header().tile_type == coast::TILE_TYPE => {
            let shores = coast::Shores::decode(&what, bytes)?;
            let z = stored(archive, id).z;
            let inland =
                (z == id.z && id.projection == Projection::Mercator).then(|| Arc::new(Inland::of(id, &shores)));
            return Ok(coast::field::field(id, z, &shores).map(|own| Decoded::Near(own, inland)));
        }
        Layer::Water => return water::decode(&what, bytes).map(|shores| Some(Decoded::Near(shores, None))),
        Layer::Imagery => TileTexels::Imagery(imagery::decode(&what, bytes)?),
    };
    Ok(Some(Decoded::Whole(texels)))
}
