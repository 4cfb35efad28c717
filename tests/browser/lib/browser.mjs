// A headless Chromium with WebGPU in software, and a page with its console kept.

import { chromium } from "playwright-core";
import { findChromium } from "./chromium.mjs";
import { decode } from "./picture.mjs";

const QUIET = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
// All through Vulkan on SwiftShader: with another way to the canvas the device is lost at the first frame.
const WEBGPU = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--use-gl=angle", "--use-angle=vulkan", "--use-vulkan=swiftshader", "--enable-features=Vulkan", "--ignore-gpu-blocklist"];

/** Two cores that draw a frame in half a second need time to compile pipelines and to stream tiles. */
export const SETTLE_MS = 180_000;

/** One browser; close it before the next one starts. */
export const launch = ({ webgpu = true } = {}) =>
  chromium.launch({ executablePath: findChromium(), args: webgpu ? [...QUIET, ...WEBGPU] : QUIET });

/** The globe in a page of its own, 640 x 360 pixels unless told otherwise. */
export class Globe {
  /** Opens `address` with `#fragment`; `prepare(page)` may change the page before its scripts run. */
  static async open(browser, address, { fragment = "", query = "", size = [640, 360], prepare } = {}) {
    const context = await browser.newContext({ viewport: { width: size[0], height: size[1] }, deviceScaleFactor: 1 });
    const page = await context.newPage();
    const globe = new Globe(page, address);
    await prepare?.(page);
    await page.goto(`${address}${query}${fragment}`);
    return globe;
  }

  constructor(page, address) {
    this.page = page;
    this.console = [];
    this.strangers = [];
    page.on("console", (message) => this.console.push({ type: message.type(), text: message.text() }));
    page.on("pageerror", (error) => this.console.push({ type: "error", text: `uncaught: ${error.message}` }));
    page.on("crash", () => this.console.push({ type: "error", text: "the page crashed" }));
    page.on("request", (request) => {
      if (/^(https?|wss?):/.test(request.url()) && !request.url().startsWith(address)) this.strangers.push(request.url());
    });
  }

  /** Lines of the console that a person would worry about. */
  errors() {
    return this.console.filter(({ type }) => type === "error").map(({ text }) => text);
  }

  /** The state of the page: loading, running, unsupported or failed. */
  state() {
    return this.page.evaluate(() => document.documentElement.dataset.state);
  }

  /** Waits until the picture is complete: everything loaded, nothing pending. */
  async settled() {
    const end = this.page.waitForFunction(
      () =>
        document.documentElement.dataset.state === "failed" ||
        document.documentElement.dataset.state === "unsupported" ||
        document.getElementById("globe").dataset.state === "settled",
      null,
      { timeout: SETTLE_MS, polling: 100 },
    );
    await end.catch((error) => {
      throw new Error(`${error.message}\nconsole:\n${this.console.map(({ type, text }) => `${type}: ${text}`).join("\n")}`);
    });
    const state = await this.state();
    if (state !== "running" && state !== "loading") throw new Error(`the page is ${state}:\n${this.errors().join("\n")}`);
    // The canvas says so in the frame that it draws; the screen shows it in one of the next.
    await this.page.waitForFunction(() => document.documentElement.dataset.state === "running");
    await this.page.evaluate(() => new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 500)));
  }

  /** What `act` leads to, which must be another view or another sea, once the picture is complete again. */
  async settledAfter(act) {
    const shown = () => this.page.evaluate(() => document.getElementById("globe").dataset.fragment);
    const old = await shown();
    await act();
    const end = Date.now() + SETTLE_MS;
    while ((await shown()) === old) {
      if (Date.now() > end) throw new Error(`the view stays as it is: ${old}`);
      await this.page.waitForTimeout(50);
    }
    await this.settled();
  }

  /** Middle of a widget of the panel, by the name that the program gives it. */
  async widget(name) {
    const widgets = JSON.parse(await this.page.evaluate(() => document.getElementById("globe").dataset.widgets));
    if (!widgets[name]) throw new Error(`no widget ${name}; there are ${Object.keys(widgets)}`);
    const [x, y, width, height] = widgets[name];
    return { x: x + width / 2, y: y + height / 2, width, height };
  }

  /** The screen, decoded. */
  async picture() {
    return decode(await this.page.screenshot({ animations: "allow", caret: "initial" }));
  }

  /** The page's fragment as an object: `{ view: "…", wind: "…" }`. */
  async fragment() {
    const hash = await this.page.evaluate(() => location.hash);
    return Object.fromEntries(new URLSearchParams(hash.slice(1).replaceAll("+", "%2B")));
  }

  close() {
    return this.page.context().close();
  }
}
