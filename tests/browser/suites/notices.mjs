// Where the globe cannot run, the page says what is missing and what to do.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Globe } from "../lib/browser.mjs";
import { startBreakable } from "../lib/servers.mjs";

/** Waits for the notice; gives the text that a person reads. */
async function notice(globe, heading) {
  const shown = await globe.page.waitForSelector('aria/[role="heading"]', { timeout: 20_000 });
  assert.match(await shown.evaluate((element) => element.innerText), heading);
  assert.equal(await globe.page.$eval("canvas", (canvas) => canvas.checkVisibility()), false);
  assert.equal(await globe.countByRole("progressbar"), 0);
  return globe.page.$eval('aria/[role="alert"]', (alert) => alert.innerText);
}

export function noticeTests(site) {
  test("a browser without WebGPU says so, and does not load the program", async () => {
    site.server.requests.length = 0;
    const globe = await site.open({ prepare: (page) => page.evaluateOnNewDocument(() => delete Navigator.prototype.gpu) });
    const text = await notice(globe, /^This globe needs WebGPU$/);
    assert.match(text, /Chrome or Edge: version 113/);
    assert.match(text, /Safari: version 26/);
    assert.match(text, /Firefox: version 141/);
    assert.equal(await globe.state(), "unsupported");
    assert.deepEqual(globe.errors(), []);
    assert.deepEqual(site.server.requests.filter(({ path }) => /\.wasm$|\.pmtiles$/.test(path)), []);
    await globe.close();
  });

  test("a real browser with its WebGPU off shows a notice too", async () => {
    const globe = await site.open();
    await notice(globe, /WebGPU|graphics card/);
    assert.equal(await globe.state(), "unsupported");
    await globe.close();
  });

  test("WebGPU without a graphics card has its own remedy", async () => {
    const prepare = (page) =>
      page.evaluateOnNewDocument(() => Object.defineProperty(navigator, "gpu", { value: { requestAdapter: async () => null } }));
    const globe = await site.open({ prepare });
    assert.match(await notice(globe, /graphics card/), /hardware acceleration/);
    assert.equal(await globe.state(), "unsupported");
    await globe.close();
  });

  test("a page from another machine over plain http is told to use https", async () => {
    const prepare = (page) => page.evaluateOnNewDocument(() => Object.defineProperty(window, "isSecureContext", { value: false }));
    const globe = await site.open({ prepare });
    assert.match(await notice(globe, /^This globe needs WebGPU$/), /https/);
    await globe.close();
  });

  test("a program that does not load is reported, with the reason", async (t) => {
    const lost = await startBreakable({ answer: (path) => (path.endsWith(".wasm") ? 503 : undefined) });
    t.after(() => lost.close());
    const prepare = (page) =>
      page.evaluateOnNewDocument(() => Object.defineProperty(navigator, "gpu", { value: { requestAdapter: async () => ({}) } }));
    const globe = await Globe.open(site.browser, lost.address, { prepare });
    const text = await notice(globe, /^The globe could not start$/);
    assert.match(text, /\.wasm: HTTP status 503/);
    assert.match(text, /Reload/);
    assert.equal(await globe.state(), "failed");
    await globe.close();
  });
}
