// A headless Firefox or Chromium that draws in software, and a page with its console kept.

import { setTimeout as sleep } from "node:timers/promises";
import puppeteer from "puppeteer-core";
import { findBrowser } from "./find.mjs";
import { decode } from "./picture.mjs";

const QUIET = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
// All through Vulkan on SwiftShader, the only software adapter that Chromium takes: with another way to the canvas the device is
// lost at the first frame.
const WEBGPU = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--use-gl=angle", "--use-angle=vulkan", "--use-vulkan=swiftshader", "--enable-features=Vulkan", "--ignore-gpu-blocklist"];

const BROWSERS = {
  // WebGPU on Linux is still behind preferences. It runs on Mesa's lavapipe, as the native program does here.
  firefox: {
    browser: "firefox",
    executablePath: () => findBrowser("firefox"),
    extraPrefsFirefox: {
      "dom.webgpu.enabled": true,
      "gfx.webgpu.ignore-blocklist": true,
      "layers.acceleration.force-enabled": true,
      // Reading the clipboard would ask the user.
      "dom.events.testing.asyncClipboard": true,
    },
  },
  chromium: { browser: "chrome", executablePath: () => findBrowser("chromium"), args: [...QUIET, ...WEBGPU] },
  "chromium without WebGPU": { browser: "chrome", executablePath: () => findBrowser("chromium"), args: QUIET },
};

/** Two cores that draw a frame in half a second need a minute to compile pipelines and to stream tiles, and six on a bad day. */
export const SETTLE_MS = 400_000;

/** A page that compiles pipelines or simulates a new sea may answer late. */
const LONGEST_ANSWER_MS = 600_000;

/** One browser, of those above; close it before the next one starts. */
export function launch(name) {
  const { executablePath, ...options } = BROWSERS[name];
  return puppeteer.launch({ ...options, executablePath: executablePath(), headless: true, protocolTimeout: LONGEST_ANSWER_MS });
}

/** The globe in a page of its own, 640 x 360 pixels unless told otherwise. */
export class Globe {
  /** Opens `address` with `#fragment`; `prepare(page)` may change the page before its scripts run. */
  static async open(browser, address, { fragment = "", query = "", size = [640, 360], prepare } = {}) {
    const context = await browser.createBrowserContext();
    const page = await context.newPage();
    const globe = new Globe(page, address);
    await globe.resize(size);
    await prepare?.(page);
    await page.goto(`${address}${query}${fragment}`, { waitUntil: "domcontentloaded" });
    return globe;
  }

  constructor(page, address) {
    this.page = page;
    this.console = [];
    this.strangers = [];
    page.on("console", (message) => this.console.push({ type: message.type(), text: message.text() }));
    page.on("pageerror", (error) => this.console.push({ type: "error", text: `uncaught: ${error.message}` }));
    page.on("error", (error) => this.console.push({ type: "error", text: `the page crashed: ${error.message}` }));
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

  /** Makes the canvas this many pixels wide and high. */
  resize([width, height]) {
    return this.page.setViewport({ width, height, deviceScaleFactor: 1 });
  }

  /** Waits until `ask`, a function of `args` that is called in the page, gives something true. */
  async until(ask, ...args) {
    for (const end = Date.now() + SETTLE_MS; Date.now() < end; await sleep(50)) {
      if (await this.page.evaluate(ask, ...args)) return;
    }
    const lines = this.console.map(({ type, text }) => `${type}: ${text}`).join("\n");
    throw new Error(`after ${SETTLE_MS / 1000} s still not so: ${ask}\nconsole:\n${lines}`);
  }

  /** Waits until the picture is complete: everything loaded, nothing pending. */
  async settled() {
    await this.until(
      () =>
        document.documentElement.dataset.state === "failed" ||
        document.documentElement.dataset.state === "unsupported" ||
        document.getElementById("globe").dataset.state === "settled",
    );
    const state = await this.state();
    if (state !== "running" && state !== "loading") throw new Error(`the page is ${state}:\n${this.errors().join("\n")}`);
    // The canvas says so in the frame that it draws; the screen shows it in one of the next.
    await this.until(() => document.documentElement.dataset.state === "running");
    await this.page.evaluate(() => new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), 500)));
  }

  /** What `act` leads to, which must be another view or another sea, once the picture is complete again. */
  async settledAfter(act) {
    const old = await this.page.evaluate(() => document.getElementById("globe").dataset.fragment);
    await act();
    await this.until((old) => document.getElementById("globe").dataset.fragment !== old, old);
    await this.settled();
  }

  /** Follows a link to another view, without a new load of the page. */
  follow(fragment) {
    return this.settledAfter(() => this.setFragment(fragment));
  }

  /** Puts a fragment into the address. */
  setFragment(fragment) {
    return this.page.evaluate((hash) => void (location.hash = hash), fragment);
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
    return decode(await this.page.screenshot());
  }

  /** How many elements assistive technology finds by a role and, if given, a name. */
  async countByRole(role, name = "") {
    return (await this.page.$$(`aria/${name}[role="${role}"]`)).length;
  }

  /** The page's fragment as an object: `{ view: "…", wind: "…" }`. */
  async fragment() {
    const hash = await this.page.evaluate(() => location.hash);
    return Object.fromEntries(new URLSearchParams(hash.slice(1).replaceAll("+", "%2B")));
  }

  /** Closes the page and what it stored. */
  close() {
    return this.page.browserContext().close();
  }
}
