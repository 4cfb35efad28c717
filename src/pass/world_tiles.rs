//! Terrain and water tiles on the GPU: two atlases, and the page tables by which shaders find the finest tile at hand.

use std::collections::{HashMap, HashSet};

use crate::data::fetch::now_s;
use crate::data::tile::{Layer, MapPoint, Projection, TILE_TEXELS, TileId};
use crate::data::world::{Outcome, World};
use crate::data::{SharedTexels, TileTexels};
use crate::gpu::Gpu;
use crate::gpu::texture::{Shape, array_view};
use crate::scene::view::camera::Camera;

/// Levels of the page tables; equals `PAGE_LEVELS` in `shaders/lib/world.wgsl`.
pub const PAGE_LEVELS: usize = 12;
/// Tiles along a side of a level's page table; equals `PAGE_WINDOW` there.
pub const PAGE_WINDOW: usize = 64;
/// Tiles that each atlas holds; WebGPU promises 256 layers. Terrain 48 MiB, water 48 MiB.
const ATLAS_LAYERS: u32 = 192;
/// Wait before a tile that could not be had is asked for again, seconds.
const RETRY_S: f64 = 31.0;

#[derive(Clone, Copy)]
struct Resident {
    slot: u32,
    last_used: u64,
}

/// One atlas with its page table.
struct Atlas {
    layer: Layer,
    texture: wgpu::Texture,
    pages: wgpu::Buffer,
    resident: HashMap<TileId, Resident>,
    /// Tiles that the archive lacks: their parents serve.
    absent: HashSet<TileId>,
    /// Tiles that could not be had, and when to ask again, seconds: until then their parents serve.
    failed: HashMap<TileId, f64>,
    free: Vec<u32>,
    stale: bool,
}

impl Atlas {
    fn new(gpu: &Gpu, layer: Layer) -> Self {
        let (label, format) = match layer {
            Layer::Terrain => ("terrain tiles", wgpu::TextureFormat::R32Float),
            Layer::Water => ("water tiles", wgpu::TextureFormat::Rgba8Unorm),
        };
        let shape = Shape::array(TILE_TEXELS as u32, ATLAS_LAYERS, 1);
        let texture = gpu.texture(label, shape, format, wgpu::TextureUsages::COPY_DST);
        let size = (Projection::ALL.len() * PAGE_LEVELS * PAGE_WINDOW * PAGE_WINDOW * 4) as u64;
        let pages = gpu.empty_buffer(label, wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST, size);
        let mut atlas = Self {
            layer,
            texture,
            pages,
            resident: HashMap::new(),
            absent: HashSet::new(),
            failed: HashMap::new(),
            // Slot 0 is the void that is shown before the first tile: bare sea of no known depth.
            free: (1..ATLAS_LAYERS).rev().collect(),
            stale: true,
        };
        let void = match layer {
            Layer::Terrain => TileTexels::Terrain(vec![-4_000.0; TILE_TEXELS * TILE_TEXELS]),
            Layer::Water => TileTexels::Water(vec![[255, 1, 1, 0]; TILE_TEXELS * TILE_TEXELS]),
        };
        atlas.upload(gpu, 0, &void);
        atlas
    }

    fn upload(&mut self, gpu: &Gpu, slot: u32, texels: &TileTexels) {
        let bytes: &[u8] = match texels {
            TileTexels::Terrain(metres) => bytemuck::cast_slice(metres),
            TileTexels::Water(texels) => bytemuck::cast_slice(texels),
        };
        let side = TILE_TEXELS as u32;
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: 0,
                origin: wgpu::Origin3d { x: 0, y: 0, z: slot },
                aspect: wgpu::TextureAspect::All,
            },
            bytes,
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * side), rows_per_image: Some(side) },
            wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
        );
    }

    /// Notes that `id` is wanted in this frame; true when it must be asked for.
    fn want(&mut self, id: TileId, now: u64) -> bool {
        if let Some(resident) = self.resident.get_mut(&id) {
            resident.last_used = now;
            return false;
        }
        self.failed.get(&id).is_none_or(|until| *until <= now_s())
    }

    fn receive(&mut self, gpu: &Gpu, id: TileId, texels: &SharedTexels, now: u64) {
        let Some(slot) = self.free.pop().or_else(|| self.evict(now)) else { return };
        self.upload(gpu, slot, texels);
        self.resident.insert(id, Resident { slot, last_used: now });
        self.stale = true;
    }

    /// Frees the slot that has gone unused longest; roots stay.
    fn evict(&mut self, now: u64) -> Option<u32> {
        let old = |(id, r): &(&TileId, &Resident)| id.z > 0 && r.last_used + 1 < now;
        let id = *self.resident.iter().filter(old).min_by_key(|(_, r)| r.last_used)?.0;
        self.resident.remove(&id).map(|r| r.slot)
    }

    /// Rewrites the page table; `corners` holds the first tile of each level's window in each square.
    fn write_pages(&mut self, gpu: &Gpu, corners: &[[[u32; 2]; PAGE_LEVELS]; 3]) {
        let mut words = vec![0u32; Projection::ALL.len() * PAGE_LEVELS * PAGE_WINDOW * PAGE_WINDOW];
        for (square, projection) in Projection::ALL.into_iter().enumerate() {
            for (z, &corner) in corners[square].iter().enumerate() {
                let base = (square * PAGE_LEVELS + z) * PAGE_WINDOW * PAGE_WINDOW;
                let parent_base = base - PAGE_WINDOW * PAGE_WINDOW * usize::from(z > 0);
                let across = 1u32 << z;
                for dy in 0..across.min(PAGE_WINDOW as u32) {
                    for dx in 0..across.min(PAGE_WINDOW as u32) {
                        let (x, y) = (corner[0].wrapping_add(dx) % across, corner[1].wrapping_add(dy) % across);
                        let at = |x: u32, y: u32| (y as usize % PAGE_WINDOW) * PAGE_WINDOW + x as usize % PAGE_WINDOW;
                        let id = TileId { projection, z: z as u8, x, y };
                        let inherited = if z > 0 { words[parent_base + at(x / 2, y / 2)] } else { 0 };
                        let own = self.resident.get(&id).map(|r| r.slot | (z as u32) << 16);
                        words[base + at(x, y)] = own.unwrap_or(inherited);
                    }
                }
            }
        }
        gpu.queue.write_buffer(&self.pages, 0, bytemuck::cast_slice(&words));
        self.stale = false;
    }
}

/// Both atlases, fed from a [`World`].
pub struct WorldTiles {
    atlases: [Atlas; 2],
    frame: u64,
    corners: [[[u32; 2]; PAGE_LEVELS]; 3],
    /// Changes whenever what the shaders see changes.
    pub revision: u64,
}

impl WorldTiles {
    /// Empty atlases: open sea everywhere.
    pub fn new(gpu: &Gpu) -> Self {
        let atlases = [Layer::Terrain, Layer::Water].map(|layer| Atlas::new(gpu, layer));
        Self { atlases, frame: 0, corners: [[[u32::MAX; 2]; PAGE_LEVELS]; 3], revision: 0 }
    }

    /// Asks `world` for what `tiles` need, takes what has arrived, and brings the page tables up to date. True when nothing
    /// had to be asked for: all that the world has of them is here.
    pub fn update(&mut self, gpu: &Gpu, world: &mut World, camera: &Camera, tiles: &[TileId]) -> bool {
        let mut complete = true;
        self.frame += 1;
        for arrival in world.poll() {
            let atlas = &mut self.atlases[arrival.layer as usize];
            match arrival.outcome {
                Outcome::Tile(texels) => atlas.receive(gpu, arrival.id, &texels, self.frame),
                Outcome::Absent => _ = atlas.absent.insert(arrival.id),
                Outcome::Failed(_) => _ = atlas.failed.insert(arrival.id, now_s() + RETRY_S),
            }
        }
        for atlas in &mut self.atlases {
            // Also what lies under the eye, in view or not: the eye must know its ground.
            let foot = MapPoint::from_lat_lon(camera.lat, camera.lon).tile(PAGE_LEVELS as u8 - 1);
            let mut wanted: Vec<TileId> = tiles.iter().copied().chain([foot]).flat_map(lineage).collect();
            let deepest = |id: &TileId| world.max_zoom(atlas.layer, id.projection).unwrap_or(0);
            wanted.retain(|id| id.z <= deepest(id) && usize::from(id.z) < PAGE_LEVELS && !atlas.absent.contains(id));
            wanted.sort_unstable_by_key(|id| (id.z, id.projection as u8, id.y, id.x));
            wanted.dedup();
            // The coarse ones first; what the atlas cannot hold is shown through its parents.
            for id in wanted.into_iter().take(ATLAS_LAYERS as usize - 1) {
                if atlas.want(id, self.frame) {
                    world.request(atlas.layer, id);
                    complete = false;
                }
            }
        }
        let corners = page_corners(camera);
        let moved = corners != self.corners;
        self.corners = corners;
        for atlas in &mut self.atlases {
            if moved || atlas.stale {
                self.revision += 1;
                atlas.write_pages(gpu, &self.corners);
            }
        }
        complete && world.settled()
    }

    /// Terrain and water: the atlases as arrays, then the page tables.
    pub fn bindings(&self) -> ([wgpu::TextureView; 2], [&wgpu::Buffer; 2]) {
        (self.atlases.each_ref().map(|a| array_view(&a.texture)), self.atlases.each_ref().map(|a| &a.pages))
    }
}

/// A tile and its ancestors.
fn lineage(id: TileId) -> impl Iterator<Item = TileId> {
    std::iter::successors(Some(id), |id| id.parent())
}

/// First tile of each level's window: half a window before the eye's own tile. Must hold the tiles that shaders look up,
/// which lie within 16 of the reference point.
fn page_corners(camera: &Camera) -> [[[u32; 2]; PAGE_LEVELS]; 3] {
    Projection::ALL.map(|projection| {
        let side = match projection {
            Projection::Mercator => 0.0,
            Projection::North => 1.0,
            Projection::South => -1.0,
        };
        let far = side != 0.0 && camera.lat * side <= 80f64.to_radians();
        let lat = if far { side * std::f64::consts::FRAC_PI_2 } else { camera.lat };
        let eye = MapPoint::on(projection, lat, camera.lon);
        std::array::from_fn(|z| {
            let tile = eye.tile(z as u8);
            let half = PAGE_WINDOW as u32 / 2;
            if (1usize << z) <= PAGE_WINDOW { [0, 0] } else { [tile.x.wrapping_sub(half), tile.y.wrapping_sub(half)] }
        })
    })
}
