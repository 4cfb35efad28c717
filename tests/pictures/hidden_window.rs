//! The whole program in a window without a screen, as a test drives it: events in, pictures and facts out.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::time::{Duration, Instant};

use eframe::App as _;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, pos2, vec2};
use egui_wgpu::{RenderState, RendererOptions, ScreenDescriptor, WgpuConfiguration, WgpuSetup, wgpu};
use ocean_globe::app::page::Page;
use ocean_globe::app::{App, Options};
use ocean_globe::data::world::World;
use ocean_globe::gpu::Gpu;
use ocean_globe::renderer::Renderer;
use ocean_globe::scene::view::state::ViewState;

/// What the program has told the page.
#[derive(Default)]
pub struct Record {
    pub facts: HashMap<String, String>,
    /// Every change of the fragment, and whether it made an entry in the history.
    pub addresses: Vec<(String, bool)>,
    /// A fragment that somebody else has set.
    pub arriving: Option<String>,
}

struct TestPage(Rc<RefCell<Record>>);

impl Page for TestPage {
    fn new_fragment(&mut self) -> Option<String> {
        self.0.borrow_mut().arriving.take()
    }

    fn set_fragment(&mut self, fragment: &str, push: bool) {
        self.0.borrow_mut().addresses.push((fragment.to_owned(), push));
    }

    fn link(&self, fragment: &str) -> String {
        format!("https://page.example/#{fragment}")
    }

    fn publish(&mut self, name: &str, value: &str) {
        self.0.borrow_mut().facts.insert(name.to_owned(), value.to_owned());
    }
}

/// The window.
pub struct Window {
    context: egui::Context,
    pub host: RenderState,
    pub gpu: Gpu,
    app: App,
    pub page: Rc<RefCell<Record>>,
    size: [u32; 2],
    time_s: f64,
    pub commands: Vec<egui::OutputCommand>,
    /// When the program wants to be called again if nothing happens.
    pub repaint_delay: Duration,
}

impl Window {
    /// A window of so many pixels with the program on a link's fragment.
    pub fn open(state: &str, panel: bool, size: [u32; 2]) -> Self {
        let mut config = WgpuConfiguration::default();
        if let WgpuSetup::CreateNew(setup) = &mut config.wgpu_setup {
            setup.instance_descriptor.backends = wgpu::Backends::PRIMARY;
            setup.device_descriptor = std::sync::Arc::new(ocean_globe::gpu::context::device_descriptor);
        }
        let instance = pollster::block_on(config.wgpu_setup.new_instance());
        let host = pollster::block_on(RenderState::create(&config, &instance, None, RendererOptions::default()));
        let host = host.expect("a graphics adapter, if only a software one");
        let gpu = Gpu::new(&host.adapter, host.device.clone(), host.queue.clone());
        let renderer = renderer(&gpu);
        let context = egui::Context::default();
        let mut creation = eframe::CreationContext::_new_kittest(context.clone());
        creation.wgpu_render_state = Some(host.clone());
        let (state, errors) = ViewState::parse_fragment(state, None);
        assert!(errors.is_empty(), "{errors:?}");
        let page = Rc::new(RefCell::new(Record::default()));
        let options = Options { state, panel };
        let app = App::new(&creation, gpu.clone(), renderer, options, Box::new(TestPage(page.clone())));
        let app = app.expect("an app on a working device");
        let mut window = Self {
            context,
            host,
            gpu,
            app,
            page,
            size,
            time_s: 0.0,
            commands: Vec::new(),
            repaint_delay: Duration::ZERO,
        };
        // egui needs a second frame to know the sizes of its areas.
        window.frame(vec![]);
        window.frame(vec![]);
        window
    }

    /// One frame with some events; returns the picture, RGBA rows from the top.
    pub fn frame(&mut self, events: Vec<Event>) -> Vec<u8> {
        let screen = Rect::from_min_size(Pos2::ZERO, vec2(self.size[0] as f32, self.size[1] as f32));
        self.time_s += 1.0 / 60.0;
        let input = egui::RawInput { screen_rect: Some(screen), events, time: Some(self.time_s), ..Default::default() };
        let mut frame = eframe::Frame::_new_kittest();
        let mut output = self.context.run_ui(input, |ui| self.app.ui(ui, &mut frame));
        self.commands.append(&mut output.platform_output.commands);
        self.repaint_delay = output.viewport_output[&egui::ViewportId::ROOT].repaint_delay;
        let shapes = self.context.tessellate(output.shapes, output.pixels_per_point);
        self.paint(&shapes, output.textures_delta)
    }

    fn paint(&self, shapes: &[egui::ClippedPrimitive], mut textures: egui::TexturesDelta) -> Vec<u8> {
        let device = &self.host.device;
        let target = target(device, self.host.target_format, self.size);
        let view = target.create_view(&Default::default());
        let screen = ScreenDescriptor { size_in_pixels: self.size, pixels_per_point: 1.0 };
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut renderer = self.host.renderer.write();
        for (id, deltas) in textures.set.drain() {
            deltas.iter().for_each(|delta| renderer.update_texture(device, &self.host.queue, id, delta));
        }
        let extra = renderer.update_buffers(device, &self.host.queue, &mut encoder, shapes, &screen);
        let attachment = wgpu::RenderPassColorAttachment {
            view: &view,
            resolve_target: None,
            // No picture has this colour all over: what is not painted shows.
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::GREEN), store: wgpu::StoreOp::Store },
            depth_slice: None,
        };
        let pass = wgpu::RenderPassDescriptor { color_attachments: &[Some(attachment)], ..Default::default() };
        renderer.render(&mut encoder.begin_render_pass(&pass).forget_lifetime(), shapes, &screen);
        self.host.queue.submit(extra.into_iter().chain([encoder.finish()]));
        self.gpu.read_texture(&target, 0, 0).expect("a readable target")
    }

    /// Frames until everything is drawn as it is to stay.
    pub fn settle(&mut self) {
        self.frame(vec![]);
        while self.fact("state") != "settled" {
            std::thread::sleep(Duration::from_millis(5));
            self.frame(vec![]);
        }
    }

    /// Pictures that the device has finished.
    pub fn pictures(&self) -> u32 {
        self.fact("pictures").parse().expect("a number")
    }

    /// Frames for some seconds, called as a host would; returns how many frames there were, and pictures.
    pub fn run_for(&mut self, seconds: f64) -> [u32; 2] {
        let (start, before) = (Instant::now(), self.pictures());
        let mut frames = 0;
        while start.elapsed().as_secs_f64() < seconds {
            let left = Duration::from_secs_f64(seconds).saturating_sub(start.elapsed());
            std::thread::sleep(self.repaint_delay.min(left));
            self.frame(vec![]);
            frames += 1;
        }
        [frames, self.pictures() - before]
    }

    /// What the program has published under a name.
    pub fn fact(&self, name: &str) -> String {
        self.page.borrow().facts.get(name).cloned().unwrap_or_default()
    }

    /// The view that it has published.
    pub fn state(&self) -> ViewState {
        ViewState::parse_fragment(&self.fact("fragment"), None).0
    }

    /// The rectangle of a widget as the page is told it.
    pub fn widget(&self, name: &str) -> Option<Rect> {
        let all: serde_json::Value = serde_json::from_str(&self.fact("widgets")).expect("JSON");
        let sides: Vec<f32> =
            all.get(name)?.as_array()?.iter().filter_map(|side| side.as_f64()).map(|s| s as f32).collect();
        Some(Rect::from_min_size(pos2(sides[0], sides[1]), vec2(sides[2], sides[3])))
    }

    /// Presses or lets go the button at a point.
    pub fn press(&mut self, at: Pos2, pressed: bool) {
        let button = PointerButton::Primary;
        self.frame(vec![
            Event::PointerMoved(at),
            Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE },
        ]);
    }

    /// Clicks on a widget.
    pub fn click(&mut self, name: &str) {
        let at = self.widget(name).unwrap_or_else(|| panic!("no widget {name}")).center();
        self.frame(vec![Event::PointerMoved(at)]);
        self.press(at, true);
        self.press(at, false);
        self.frame(vec![]);
    }

    /// Presses a key.
    pub fn key(&mut self, key: Key) {
        for pressed in [true, false] {
            let event = Event::Key { key, physical_key: None, pressed, repeat: false, modifiers: Modifiers::NONE };
            self.frame(vec![event]);
        }
        self.frame(vec![]);
    }
}

/// A renderer of the bundled world.
pub fn renderer(gpu: &Gpu) -> Renderer {
    pollster::block_on(Renderer::new(gpu.clone(), World::open("www/data"))).expect("the program's own shaders")
}

/// A texture to draw into and read.
pub fn target(device: &wgpu::Device, format: wgpu::TextureFormat, [width, height]: [u32; 2]) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("target"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}
