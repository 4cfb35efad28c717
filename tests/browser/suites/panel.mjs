// The panel, by mouse and keyboard: the wind and the picture follow.

import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { difference } from "../lib/picture.mjs";
import { AT_SEA } from "../lib/views.mjs";

export const panelTests = (site) => describe("the panel", () => {
  let globe;
  before(async () => {
    // Every click is followed by a new sea: a coarse one serves, and takes less time.
    globe = await site.open({ fragment: `${AT_SEA}&quality=low` });
    await globe.settled();
  });

  /** The left half of the screen, which the panel leaves free. */
  async function sea() {
    const { width, height, data } = await globe.picture();
    const half = Buffer.concat(Array.from({ length: height }, (_, row) => data.subarray(4 * width * row, 4 * width * row + 2 * width)));
    return { width: width / 2, height, data: half };
  }

  /** What a click at a part of a widget's width leads to. */
  async function click(name, part = 0.5) {
    const { x, y, width } = await globe.widget(name);
    await globe.settledAfter(() => globe.page.mouse.click(x + (part - 0.5) * width, y, { delay: 100 }));
  }

  /** The wind of the page's address, once it has become another one than `old`. */
  async function windAfter(old) {
    for (let tries = 0; tries < 100; tries += 1) {
      const { wind } = await globe.fragment();
      if (wind !== old) return wind.split("@").map(Number);
      await sleep(50);
    }
    throw new Error(`the address keeps wind=${old}`);
  }

  test("the wind's speed changes the sea and the address", async () => {
    const before = await sea();
    await click("windSpeed", 0.3);
    const [speed, from] = await windAfter("14@250");
    assert.ok(speed > 20 && speed <= 60, `speed ${speed}`);
    assert.equal(from, 250);
    const { mean } = difference(before, await sea());
    assert.ok(mean > 2, `the picture hardly changes: ${mean}`);
    // The figures are those of the new wind: the measured whitecap fraction, capped at a quarter; the Beaufort table's heights.
    const figures = JSON.parse(await globe.page.evaluate(() => document.getElementById("globe").dataset.sea));
    assert.ok(Math.abs(figures.whitecaps - Math.min(3.84e-6 * speed ** 3.41, 0.25)) < 1e-4, `${speed} m/s: ${figures.whitecaps}`);
    assert.ok(figures.hs_m > 5.5 && figures.hs_m <= 14 && figures.tp_s > 8, `${figures.hs_m} m, ${figures.tp_s} s`);
    // Cox and Munk's line, to 10 %.
    assert.ok(Math.abs(figures.mean_square_slope / (0.003 + 0.00512 * speed) - 1) < 0.1, `${figures.mean_square_slope}`);
  });

  test("the dial turns the wind, and the waves with it", async () => {
    const [before, { wind }] = [await sea(), await globe.fragment()];
    await click("windDial", 0.9);
    const [speed, from] = await windAfter(wind);
    assert.equal(speed, Number(wind.split("@")[0]));
    assert.ok(Math.abs(from - 90) < 10, `a click in the east of the dial gives wind from ${from}`);
    const { mean } = difference(before, await sea());
    assert.ok(mean > 2, `the picture hardly changes: ${mean}`);
  });

  test("a named view is an entry of the history", async () => {
    const { view } = await globe.fragment();
    const entries = await globe.page.evaluate(() => history.length);
    await click("viewOcean");
    assert.equal(await globe.page.evaluate(() => history.length), entries + 1);
    await globe.settledAfter(() => globe.page.evaluate(() => history.back()));
    assert.equal((await globe.fragment()).view, view);
  });

  test("the copied link is the address", async () => {
    const { x, y } = await globe.widget("copyLink");
    await globe.page.mouse.click(x, y, { delay: 100 });
    await sleep(1000);
    const { hash, text } = await globe.page.evaluate(async () => ({ hash: location.hash, text: await navigator.clipboard.readText() }));
    assert.equal(text, `${site.server.address}${hash}`);
  });

  test("H hides the panel, the keyboard moves the view", async () => {
    const shown = await globe.picture();
    await globe.page.focus("canvas");
    await globe.page.keyboard.press("h", { delay: 100 });
    await globe.until(() => document.getElementById("globe").dataset.widgets === "{}");
    await globe.settled();
    const hidden = await globe.picture();
    assert.ok(difference(shown, hidden).mean > 1, "the panel is still there");
    await globe.settledAfter(() => globe.page.keyboard.press("PageUp", { delay: 500 }));
    assert.ok(difference(hidden, await globe.picture()).mean > 1, "the view has not moved");
    assert.deepEqual(globe.errors(), []);
  });
});
