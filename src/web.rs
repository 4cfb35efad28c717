//! The browser's side: starts the program on a canvas and joins it to the page's address.
//!
//! Nothing here calls into JavaScript that could call back while Rust holds a borrow: the page's events only raise a flag,
//! which the next frame reads.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::rc::Rc;

use egui_wgpu::{WgpuSetup, WgpuSetupExisting, wgpu};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{HtmlCanvasElement, Window};

use crate::app::clock::unix_now_s;
use crate::app::page::Page;
use crate::app::{App, Options};
use crate::data::world::World;
use crate::error::{Error, Result};
use crate::gpu::{Gpu, context::device_descriptor};
use crate::model::waves;
use crate::renderer::Renderer;
use crate::scene::measured_place::{MeasuredPlaces, Question};
use crate::scene::sea::Seas;
use crate::scene::view::named;
use crate::scene::view::state::ViewState;

/// Starts the globe on a canvas, with the world's tiles below `data_base`.
///
/// The canvas tells how it goes: `data-state` is `loading`, `settled` or `failed`; `data-error`, `data-fragment`,
/// `data-frame-ms`, `data-pictures` (how many are finished), `data-scale` (pixels of the last one along a pixel of the canvas) and
/// `data-widgets` (rectangles of the panel's widgets, CSS pixels) say more. `?panel=off` in the page's
/// address hides the panel.
///
/// # Errors
/// One line of text where there is no WebGPU or the device fails; it is on the console and in `data-error` too.
#[wasm_bindgen]
pub async fn start(canvas: HtmlCanvasElement, data_base: String) -> std::result::Result<(), JsValue> {
    console_error_panic_hook::set_once();
    // A second start finds the logger in place.
    let _ = eframe::WebLogger::init(log::LevelFilter::Warn);
    // A canvas whose data set cannot be written has bigger troubles.
    let _ = canvas.set_attribute("data-state", "loading");
    let started = run(canvas.clone(), &data_base).await;
    started.map_err(|error| {
        let text = error.to_string();
        web_sys::console::error_1(&JsValue::from_str(&format!("ocean-globe: {text}")));
        let _ = canvas.set_attribute("data-error", &text);
        let _ = canvas.set_attribute("data-state", "failed");
        JsValue::from_str(&text)
    })
}

async fn run(canvas: HtmlCanvasElement, data_base: &str) -> Result<()> {
    let (setup, gpu) = device().await?;
    let renderer = Renderer::new(gpu.clone(), World::open(data_base)).await?;
    let page = WebPage::new(canvas.clone())?;
    let search = page.window.location().search().unwrap_or_default();
    let panel = !search.trim_start_matches('?').split('&').any(|pair| pair == "panel=off");
    let (mut state, errors) = ViewState::parse_fragment(&page.fragment(), None);
    if page.fragment().trim_start_matches('#').is_empty() {
        state = named::opening(unix_now_s());
    }
    errors.iter().for_each(|error| log::warn!("link: {error}"));
    let options = eframe::WebOptions {
        wgpu_options: egui_wgpu::WgpuConfiguration { wgpu_setup: WgpuSetup::Existing(setup), ..Default::default() },
        ..Default::default()
    };
    let create: eframe::AppCreator<'static> = Box::new(move |host| {
        page.listen(&host.egui_ctx);
        Ok(Box::new(App::new(host, gpu, renderer, Options { state, panel }, Box::new(page))?))
    });
    let failed = |error: JsValue| Error::gpu(text_of(&error), "reload the page, or try another browser");
    eframe::WebRunner::new().start(canvas, options, create).await.map_err(failed)
}

/// A WebGPU device. It is made here and not by eframe, because the renderer's shaders are checked asynchronously.
async fn device() -> Result<(WgpuSetupExisting, Gpu)> {
    let remedy = "use a browser with WebGPU (Chrome or Edge 113, Safari 26, Firefox 141 or later) over https";
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::BROWSER_WEBGPU;
    let instance = wgpu::Instance::new(descriptor);
    let wanted =
        wgpu::RequestAdapterOptions { power_preference: wgpu::PowerPreference::HighPerformance, ..Default::default() };
    let adapter = instance.request_adapter(&wanted).await;
    let adapter =
        adapter.map_err(|error| Error::gpu(format!("this browser gives no WebGPU adapter: {error}"), remedy))?;
    let device = adapter.request_device(&device_descriptor(&adapter)).await;
    let (device, queue) = device.map_err(|error| Error::gpu(format!("no WebGPU device: {error}"), remedy))?;
    let gpu = Gpu::new(&adapter, device.clone(), queue.clone());
    Ok((WgpuSetupExisting { instance, adapter, device, queue }, gpu))
}

/// The page around the canvas.
struct WebPage {
    window: Window,
    canvas: HtmlCanvasElement,
    /// Raised when the fragment has changed by a link, back or forward.
    changed: Rc<Cell<bool>>,
    /// What was last published, so that the page is touched only where something is new.
    published: HashMap<String, String>,
}

impl WebPage {
    fn new(canvas: HtmlCanvasElement) -> Result<Self> {
        let window = web_sys::window().ok_or_else(|| Error::gpu("there is no window", "start the globe in a page"))?;
        Ok(Self { window, canvas, changed: Rc::default(), published: HashMap::new() })
    }

    fn fragment(&self) -> String {
        self.window.location().hash().unwrap_or_default()
    }

    /// Watches the address. The listeners live as long as the page.
    fn listen(&self, context: &egui::Context) {
        for event in ["hashchange", "popstate"] {
            let (changed, context) = (self.changed.clone(), context.clone());
            let listener = Closure::<dyn Fn()>::new(move || {
                changed.set(true);
                context.request_repaint();
            });
            if self.window.add_event_listener_with_callback(event, listener.as_ref().unchecked_ref()).is_err() {
                log::warn!("the page refuses to tell about {event}; back and forward do not work");
            }
            listener.forget();
        }
    }
}

impl Page for WebPage {
    fn new_fragment(&mut self) -> Option<String> {
        self.changed.replace(false).then(|| self.fragment())
    }

    fn set_fragment(&mut self, fragment: &str, push: bool) {
        let url = format!("#{fragment}");
        let set = self.window.history().and_then(|history| {
            let none = JsValue::NULL;
            if push {
                history.push_state_with_url(&none, "", Some(&url))
            } else {
                history.replace_state_with_url(&none, "", Some(&url))
            }
        });
        if let Err(error) = set {
            log::warn!("the address cannot be set: {}", text_of(&error));
        }
    }

    fn link(&self, fragment: &str) -> String {
        let href = self.window.location().href().unwrap_or_default();
        format!("{}#{fragment}", href.split('#').next().unwrap_or_default())
    }

    fn publish(&mut self, name: &str, value: &str) {
        if self.published.get(name).is_some_and(|known| known == value) {
            return;
        }
        let _ = self.canvas.set_attribute(&format!("data-{name}"), value);
        self.published.insert(name.to_owned(), value.to_owned());
    }
}

/// The text of whatever JavaScript threw.
fn text_of(error: &JsValue) -> String {
    error.as_string().unwrap_or_else(|| format!("{error:?}"))
}

/// Hash of the wave amplitudes of a sea, as 16 hexadecimal digits: the same natively and here, or the sea differs.
#[wasm_bindgen]
pub fn h0_hash(seed: u32, speed_mps: f64) -> String {
    waves_hash(seed, speed_mps)
}

/// An error as scripts have them.
fn failed(error: Error) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// The surface of the sea at a place and an instant as it is drawn, by shores and on lakes whose level is known too: a promise of
/// `{height, normal: [east, north, up]}`, metres over the drawn ellipsoid and a unit vector, or of `null` on dry land, on waters without waves and, with `quality=low`, on lakes.
/// Within 2 cm of a picture whose eye is within 2 km, outside of breaking crests; within them a place may have more than one surface, and this is the one over the water that
/// rests there. `data_base` is where the world's archives lie, `data/` on the page of this program; `fragment` a link's, which says the sea; `time` ISO 8601,
/// `now`, or empty for the link's.
///
/// It loads what the place needs, once, as [`measure`] does, which tells more. The first sample of an instant costs some tenths of a second, further ones
/// little: ask for many places of one instant.
///
/// # Errors
/// Those of [`measure`].
#[wasm_bindgen(js_name = sampleSurface)]
pub async fn sample_surface(
    data_base: String,
    fragment: String,
    lng: f64,
    lat: f64,
    time: String,
) -> std::result::Result<JsValue, JsValue> {
    let found = measured(&data_base, &fragment, (lng, lat), &time).await?;
    let surface = &found["surface"];
    let Some(height_m) = surface["height_m"].as_f64() else { return Ok(JsValue::NULL) };
    let normal = [0, 1, 2].map(|axis: usize| surface["normal_enu"][axis].as_f64().unwrap_or(f64::NAN));
    surface_object(height_m, normal)
}

/// The surface of the open sea at a place, as if there were no land: what [`sample_surface`] tells far from it, at once and without loading anything. The
/// arguments are its own.
///
/// The first sample of an instant costs some tenths of a second, further ones microseconds: ask for many places of one instant.
///
/// # Errors
/// An `Error` that says in one line which argument is not valid and what would be.
#[wasm_bindgen(js_name = sampleOpenSea)]
pub fn sample_open_sea(fragment: &str, lng: f64, lat: f64, time: &str) -> std::result::Result<JsValue, JsValue> {
    thread_local! {
        /// The sea that the page's scripts measure, which need not be the one that the page shows.
        static MEASURED: RefCell<Seas> = RefCell::default();
    }
    let asked = Question::of_script(fragment, lng, lat, time, unix_now_s()).map_err(failed)?;
    let sample = MEASURED.with_borrow_mut(|seas| asked.open_sea(seas));
    surface_object(sample.height_m, sample.normal_enu)
}

/// As scripts have a surface.
fn surface_object(height_m: f64, normal_enu: [f64; 3]) -> std::result::Result<JsValue, JsValue> {
    let object = js_sys::Object::new();
    let normal: js_sys::Array = normal_enu.into_iter().map(JsValue::from_f64).collect();
    js_sys::Reflect::set(&object, &"height".into(), &height_m.into())?;
    js_sys::Reflect::set(&object, &"normal".into(), &normal)?;
    Ok(object.into())
}

/// Milliseconds after which [`measure`] looks again for tiles that are on their way, and after how many it gives up.
const MEASURE_MS: [i32; 2] = [10, 60_000];

/// What is at a place and an instant, ground and sea, by shores too, in the numbers that are drawn: a promise of the object that
/// `ocean-globe sample` prints. The arguments are those of [`sample_surface`].
///
/// It loads what the place needs, once: some hundred milliseconds for a first place, a few for others nearby.
///
/// # Errors
/// An `Error` that says in one line which argument is not valid and what would be, or what could not be fetched.
#[wasm_bindgen]
pub async fn measure(
    data_base: String,
    fragment: String,
    lng: f64,
    lat: f64,
    time: String,
) -> std::result::Result<JsValue, JsValue> {
    js_sys::JSON::parse(&measured(&data_base, &fragment, (lng, lat), &time).await?.to_string())
}

/// See [`measure`].
async fn measured(
    data_base: &str,
    fragment: &str,
    (lng, lat): (f64, f64),
    time: &str,
) -> std::result::Result<serde_json::Value, JsValue> {
    thread_local! {
        /// The worlds that scripts measure, by where they lie. They are not the one on show: that has the tiles of its view alone.
        static MEASURED: RefCell<HashMap<String, (World, MeasuredPlaces)>> = RefCell::default();
    }
    let asked = Question::of_script(fragment, lng, lat, time, unix_now_s()).map_err(failed)?;
    let [wait_ms, patience_ms] = MEASURE_MS;
    for _ in 0..patience_ms / wait_ms {
        // Nothing is held while the page goes on: others may measure meanwhile.
        let found = MEASURED.with_borrow_mut(|worlds| {
            let (world, places) = worlds
                .entry(data_base.to_owned())
                .or_insert_with(|| (World::open(data_base), MeasuredPlaces::default()));
            world.poll();
            let found = places.at(world, &asked, World::look_strictly);
            // What could not be fetched may be there when a script asks again.
            if found.is_err() {
                worlds.remove(data_base);
            }
            found
        });
        if let Some(found) = found.map_err(failed)? {
            return Ok(found);
        }
        let later = |resolve, _| {
            // Where there is no window nothing would ever come: the promise stays as it is.
            let _ = web_sys::window()
                .map(|window| window.set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, wait_ms));
        };
        JsFuture::from(js_sys::Promise::new(&mut { later })).await?;
    }
    let why = format!("has not delivered the place's tiles in {} s", patience_ms / 1000);
    Err(failed(Error::Fetch { url: data_base.to_owned(), why }))
}

/// See [`h0_hash`]. All patches of 256 by 256 samples in a row.
pub fn waves_hash(seed: u32, speed_mps: f64) -> String {
    let sea = waves::Sea::from_wind(speed_mps, seed, 1.0);
    let patches = waves::cascades(256);
    let amplitudes =
        patches.iter().enumerate().flat_map(|(index, patch)| waves::initial_amplitudes(&sea, index, patch));
    format!("{:016x}", waves::hash(&amplitudes.collect::<Vec<_>>()))
}
