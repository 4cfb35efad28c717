// The page comes up in a real browser and shows the globe.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { before, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { colourAt, kindOf, shares } from "../lib/picture.mjs";
import { COAST, FROM_ORBIT } from "../lib/views.mjs";

/** In a page, before its scripts run: it does not get past looking for an adapter until `goOn()` is called. */
function holdLoading() {
  const goingOn = new Promise((goOn) => Object.assign(window, { goOn }));
  const { requestAdapter } = GPU.prototype;
  GPU.prototype.requestAdapter = async function (...options) {
    await goingOn;
    return requestAdapter.apply(this, options);
  };
}

export function startTests(site) {
  /** What the page says before its first picture. */
  const loading = {};
  before(async () => {
    site.globe = await site.openLink(FROM_ORBIT, undefined, (page) => page.evaluateOnNewDocument(holdLoading));
    site.shown = FROM_ORBIT;
    try {
      await lookWhileLoading();
    } finally {
      await site.globe.page.evaluate(() => goOn());
    }
  });
  async function lookWhileLoading() {
    loading.state = await site.globe.state();
    loading.status = await site.globe.page.$eval("#status", (status) => status.innerText);
    // Firefox starts its tree of what is accessible when it is first asked for it; on a busy machine that takes longer than a first picture.
    for (const end = Date.now() + 60_000; !loading.progressBars && Date.now() < end; await sleep(50)) {
      loading.progressBars = await site.globe.countByRole("progressbar");
    }
  }

  test("loads without an error, asks no other host, and shows sea and land", async () => {
    assert.equal(loading.state, "loading");
    const picture = await site.pictureOf(FROM_ORBIT);
    assert.deepEqual(site.globe.errors(), []);
    assert.deepEqual(site.globe.strangers, []);
    assert.equal(await site.globe.state(), "running");

    const share = shares(picture);
    assert.ok(share.sea > 0.2 && share.land > 0.2, JSON.stringify(share));
    const middle = colourAt(picture, 0.5, 0.5);
    assert.equal(kindOf(middle), "land", `the middle of Spain is ${middle}`);
  });

  test("the globe is a labelled element that takes the keyboard", async () => {
    assert.equal(loading.progressBars, 1);
    assert.match(loading.status, /loading|preparing/i);
    const { page } = await site.show(FROM_ORBIT);
    const canvas = 'aria/Globe with a moving sea[role="application"]';
    assert.equal(await page.$eval(canvas, (element) => element.getAttribute("tabindex")), "0");
    const help = await page.$eval(canvas, (element) => document.getElementById(element.getAttribute("aria-describedby")).textContent);
    assert.match(help, /arrow keys/i);
    assert.equal(await page.$eval("#poster", (poster) => getComputedStyle(poster).pointerEvents), "none");
  });

  test("the coast lies where it is: sea in the west, land in the east", async () => {
    const picture = await site.pictureOf(COAST);
    const west = colourAt(picture, 0.1, 0.5);
    const east = colourAt(picture, 0.75, 0.4);
    assert.equal(kindOf(west), "sea", `west: ${west}`);
    assert.equal(kindOf(east), "land", `east: ${east}`);
  });

  test("the waves have the same bits as natively", async () => {
    const { cases } = JSON.parse(await readFile(new URL("../../oracles/same_sea.json", import.meta.url)));
    const found = await site.globe.page.evaluate(async (seas) => {
      const program = await import(document.getElementById("program").href);
      return seas.map(({ seed, speed_mps }) => program.h0_hash(seed, speed_mps));
    }, cases);
    assert.ok(cases.length > 0);
    assert.deepEqual(found, cases.map(({ hash }) => hash));
  });
}
