// The page comes up in a real browser and shows the globe.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { colourAt, kindOf, shares } from "./lib/picture.mjs";
import { visit } from "./lib/site.mjs";
import { COAST, FROM_ORBIT } from "./lib/views.mjs";

const site = visit();

test("loads without an error, asks no other host, and shows sea and land", async () => {
  const globe = await site.openLink(FROM_ORBIT);
  assert.equal(await globe.state(), "loading");
  await globe.settled();
  assert.deepEqual(globe.errors(), []);
  assert.deepEqual(globe.strangers, []);
  assert.equal(await globe.state(), "running");

  const picture = await globe.picture();
  const share = shares(picture);
  assert.ok(share.sea > 0.2 && share.land > 0.2, JSON.stringify(share));
  const middle = colourAt(picture, 0.5, 0.5);
  assert.equal(kindOf(middle), "land", `the middle of Spain is ${middle}`);
  await globe.close();
});

test("the coast lies where it is: sea in the west, land in the east", async () => {
  const globe = await site.openLink(COAST);
  await globe.settled();
  const picture = await globe.picture();
  const west = colourAt(picture, 0.1, 0.5);
  const east = colourAt(picture, 0.75, 0.4);
  assert.equal(kindOf(west), "sea", `west: ${west}`);
  assert.equal(kindOf(east), "land", `east: ${east}`);
  await globe.close();
});

test("the waves have the same bits as natively", async () => {
  const { cases } = JSON.parse(await readFile(new URL("../oracles/same_sea.json", import.meta.url)));
  const globe = await site.openLink(COAST);
  await globe.settled();
  const found = await globe.page.evaluate(async (seas) => {
    const program = await import(document.getElementById("program").href);
    return seas.map(({ seed, speed_mps }) => program.h0_hash(seed, speed_mps));
  }, cases);
  assert.ok(cases.length > 0);
  assert.deepEqual(found, cases.map(({ hash }) => hash));
  await globe.close();
});

test("the globe is a labelled element that takes the keyboard", async () => {
  const globe = await site.open({ fragment: FROM_ORBIT });
  const canvas = globe.page.getByRole("application", { name: /globe/i });
  assert.equal(await canvas.getAttribute("tabindex"), "0");
  const help = await canvas.evaluate((element) => document.getElementById(element.getAttribute("aria-describedby")).textContent);
  assert.match(help, /arrow keys/i);
  assert.equal(await globe.page.getByRole("progressbar").count(), 1);
  assert.match(await globe.page.locator("#status").innerText(), /loading|preparing/i);
  await globe.settled();
  assert.equal(await globe.page.locator("#poster").evaluate((poster) => getComputedStyle(poster).pointerEvents), "none");
  await globe.close();
});
