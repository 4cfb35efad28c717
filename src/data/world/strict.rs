//! The world for measurements: a tile that could not be had is an error there, and its parent does not serve in its place.

use super::World;
use crate::data::exposure::Found;
use crate::data::sample::{Sample, sample};
use crate::data::tile::{Layer, Projection, TileId};
use crate::error::{Error, Result};

/// How a tile is got at: [`World::look_strictly`], or a way that waits for it, after opening its archive.
pub type Look = fn(&mut World, Layer, TileId) -> Result<Found>;

impl World {
    /// As [`World::look`], but a tile that was given up, or whose archive was, is an error.
    ///
    /// # Errors
    /// [`Error::Fetch`] for such a tile.
    pub fn look_strictly(&mut self, layer: Layer, id: TileId) -> Result<Found> {
        let found = self.look(layer, id);
        let failure = match found {
            Found::Absent => self.failure_of(layer, id),
            _ => None,
        };
        failure.map_or(Ok(found), |why| Err(Error::Fetch { url: self.slot(layer, id.projection).name.clone(), why }))
    }

    fn failure_of(&self, layer: Layer, id: TileId) -> Option<String> {
        let tile = self.given_up.contains_key(&(layer, id)).then(|| format!("gave no usable tile {id}"));
        self.slot(layer, id.projection).failure().or(tile)
    }

    /// What is at geodetic `lat`, `lon` (radians); `None` while archives or tiles are on their way.
    ///
    /// # Errors
    /// What `look` reports; [`Error::BadData`] if there is no terrain at all.
    pub fn sample_by(&mut self, lat: f64, lon: f64, look: Look) -> Result<Option<Sample>> {
        let projection = Projection::for_latitude(lat);
        for layer in Layer::SHAPE {
            if self.max_zoom(layer, projection).is_none() {
                look(self, layer, TileId::root(projection))?;
            }
        }
        let deepest_water = self.max_zoom(Layer::Water, projection);
        let Some((terrain, _)) = self.terrain_at(lat).zip(deepest_water) else { return Ok(None) };
        let Some(stands) = self.stands_at(lat, lon, look)? else { return Ok(None) };
        let mut coming = false;
        let found = sample((lat, lon), terrain, deepest_water, stands, &mut |layer, id| {
            Ok(match look(self, layer, id)? {
                Found::Tile(texels) => Some(texels),
                Found::Absent => None,
                Found::Coming => {
                    coming = true;
                    None
                }
            })
        })?;
        if coming {
            return Ok(None);
        }
        let name = &self.slot(Layer::Terrain, projection).name;
        let nothing =
            || Error::bad_data(name, "holds no terrain tile", "make the data again with scripts/make-world.sh");
        found.map(Some).ok_or_else(nothing)
    }
}
