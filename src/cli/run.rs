//! `ocean-globe run`: the same program in a window.

use crate::app::clock::unix_now_s;
use crate::app::page::NoPage;
use crate::app::{self, App, Options};
use crate::data::world::World;
use crate::error::{Error, Result};
use crate::gpu::{Gpu, context::device_descriptor};
use crate::renderer::Renderer;
use crate::scene::view::named;
use crate::scene::view::state::ViewState;

/// Open the globe in a window.
#[derive(Debug, Clone, clap::Args)]
#[command(after_help = "Examples:
  ocean-globe run                                                  the whole earth
  ocean-globe run --state '#view=35.68,-14.25,2,188,84&bft=8'      two metres over the sea in a gale
  ocean-globe run --data /srv/world                                with the tiles of another folder

Drag to move, wheel to change the height, right drag to turn and tilt; H hides the panel, space stops the time.")]
pub struct RunArgs {
    /// The view, as in a link of the page; in quotes, because of the &
    #[arg(long, default_value = "", value_name = "FRAGMENT")]
    pub state: String,
    /// Folder of the world's tiles
    #[arg(long, default_value = "www/data", value_name = "FOLDER")]
    pub data: String,
    /// Hide the panel
    #[arg(long)]
    pub no_panel: bool,
}

/// Opens the window and returns when it is closed.
///
/// # Errors
/// [`Error::Gpu`] where no window or no device can be had.
pub fn run(args: &RunArgs) -> Result<()> {
    let (mut state, errors) = ViewState::parse_fragment(&args.state, None);
    if args.state.is_empty() {
        state = named::opening(unix_now_s());
    }
    errors.iter().for_each(|error| log::warn!("--state: {error}"));
    let mut wgpu_options = egui_wgpu::WgpuConfiguration::default();
    if let egui_wgpu::WgpuSetup::CreateNew(setup) = &mut wgpu_options.wgpu_setup {
        setup.device_descriptor = std::sync::Arc::new(device_descriptor);
    }
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default().with_title("Ocean globe").with_inner_size([1280.0, 720.0]),
        wgpu_options,
        ..Default::default()
    };
    let (data, panel) = (args.data.clone(), !args.no_panel);
    let create: eframe::AppCreator<'_> = Box::new(move |host| {
        let host_state = app::render_state(host)?;
        let gpu = Gpu::new(&host_state.adapter, host_state.device.clone(), host_state.queue.clone());
        let renderer = pollster::block_on(Renderer::new(gpu.clone(), World::open(&data)))?;
        Ok(Box::new(App::new(host, gpu, renderer, Options { state, panel }, Box::new(NoPage))?))
    });
    let failed = |error: eframe::Error| Error::gpu(error, "use `ocean-globe render` where there is no display");
    eframe::run_native("ocean-globe", options, create).map_err(failed)
}
