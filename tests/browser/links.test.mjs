// The address describes the view: links restore it, the history steps through it, garbage does no harm.

import assert from "node:assert/strict";
import { test } from "node:test";
import { difference } from "./lib/picture.mjs";
import { visit } from "./lib/site.mjs";
import { AT_SEA, COAST, FROM_ORBIT } from "./lib/views.mjs";

const { openLink: open } = visit();

test("a link restores a view: the same picture in two pages, another one for another link", async () => {
  const first = await open(AT_SEA);
  await first.settled();
  const [picture, fragment] = [await first.picture(), await first.fragment()];
  assert.match(fragment.view, /^35(\.0+)?,-30(\.0+)?,12(\.0+)?,270(\.0+)?,80/);
  assert.equal(fragment.wind, "14@250");
  await first.close();

  const second = await open(AT_SEA);
  await second.settled();
  const same = difference(picture, await second.picture());
  assert.ok(same.mean < 0.05, `the same link gives another picture: ${JSON.stringify(same)}`);
  await second.settledAfter(() => second.page.evaluate((hash) => (location.hash = hash), COAST));
  const other = difference(picture, await second.picture());
  assert.ok(other.mean > 10, `another link gives the same picture: ${JSON.stringify(other)}`);
  await second.close();
});

test("back and forward step through the views", async () => {
  const globe = await open(FROM_ORBIT);
  await globe.settled();
  const orbit = await globe.picture();
  await globe.settledAfter(() => globe.page.evaluate((hash) => (location.hash = hash), AT_SEA));
  const sea = await globe.picture();
  assert.ok(difference(orbit, sea).mean > 10);

  await globe.settledAfter(() => globe.page.goBack());
  assert.match((await globe.fragment()).view, /^38/);
  assert.ok(difference(orbit, await globe.picture()).mean < 0.05, "back shows another picture");
  await globe.settledAfter(() => globe.page.goForward());
  assert.match((await globe.fragment()).view, /^35/);
  assert.ok(difference(sea, await globe.picture()).mean < 0.05, "forward shows another picture");
  assert.deepEqual(globe.errors(), []);
  await globe.close();
});

test("garbage in the fragment never breaks the page", async () => {
  const globe = await open(`#view=nan,inf,-1e999,%00&wind=@@&seed=-1&time=yesterday&layers=,,-&%F0%9F%8C%8A=${"x".repeat(3000)}`);
  await globe.settled();
  for (const garbage of ["#", "#&&&==&=", "#view=1", "#view=%", "#12/38/x", "#wind=99999@-99999&chop=NaN", "#view=91,181,-99999,1e9,-1e9", "#<script>alert(1)</script>"]) {
    await globe.page.evaluate((hash) => (location.hash = hash), garbage);
    await globe.page.waitForTimeout(500);
    assert.equal(await globe.state(), "running", garbage);
  }
  await globe.settledAfter(() => globe.page.evaluate((hash) => (location.hash = hash), COAST));
  const picture = await globe.picture();
  assert.deepEqual(globe.errors(), []);
  await globe.close();

  const fresh = await open(COAST);
  await fresh.settled();
  const same = difference(picture, await fresh.picture());
  assert.ok(same.mean < 0.05, `after the garbage a good link gives another picture: ${JSON.stringify(same)}`);
  await fresh.close();
});
