// The address describes the view: links restore it, the history steps through it, garbage does no harm.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { difference } from "../lib/picture.mjs";
import { AT_SEA, COAST, FROM_ORBIT } from "../lib/views.mjs";

export function linkTests(site) {
  test("a link restores a view: the same picture in two pages, another one for another link", async () => {
    const picture = await site.pictureOf(AT_SEA);
    const fresh = await site.openLink(AT_SEA);
    await fresh.settled();
    const fragment = await fresh.fragment();
    assert.match(fragment.view, /^35(\.0+)?,-30(\.0+)?,12(\.0+)?,270(\.0+)?,80/);
    assert.equal(fragment.wind, "14@250");
    assert.equal(difference(picture, await fresh.picture()).worst, 0, "the same link gives another picture");
    await fresh.close();
    const other = difference(picture, await site.pictureOf(COAST));
    assert.ok(other.mean > 10, `another link gives the same picture: ${JSON.stringify(other)}`);
  });

  test("an eye that its link puts under the ground is lifted where it is drawn alone: coarse tiles, which come first, are higher", async () => {
    const globe = await site.openLink("#view=46.4,6.6,5,70,86&clouds=0&quality=low&time=2026-06-21T09:00:00Z&rate=0");
    await globe.settled();
    assert.match((await globe.fragment()).view, /^46\.40*,6\.60*,5(\.0+)?,70/);
    await globe.close();
  });

  test("back and forward step through the views", async () => {
    const globe = await site.show(FROM_ORBIT);
    const orbit = await globe.picture();
    await site.show(COAST);
    const coast = await globe.picture();
    assert.ok(difference(orbit, coast).mean > 10);

    await globe.settledAfter(() => globe.page.evaluate(() => history.back()));
    site.shown = FROM_ORBIT;
    assert.match((await globe.fragment()).view, /^38(\.0+)?,-2/);
    assert.equal(difference(orbit, await globe.picture()).worst, 0, "back shows another picture");
    await globe.settledAfter(() => globe.page.evaluate(() => history.forward()));
    site.shown = COAST;
    assert.match((await globe.fragment()).view, /^38\.70*,-9/);
    assert.equal(difference(coast, await globe.picture()).worst, 0, "forward shows another picture");
    assert.deepEqual(globe.errors(), []);
  });

  test("garbage in the fragment never breaks the page", async () => {
    const fresh = await site.pictureOf(COAST);
    const globe = await site.openLink(`#view=nan,inf,-1e999,%00&wind=@@&seed=-1&time=yesterday&layers=,,-&%F0%9F%8C%8A=${"x".repeat(3000)}`);
    await globe.settled();
    for (const garbage of ["#", "#&&&==&=", "#view=1", "#view=%", "#12/38/x", "#wind=99999@-99999&chop=NaN", "#view=91,181,-99999,1e9,-1e9", "#<script>alert(1)</script>"]) {
      await globe.setFragment(garbage);
      await sleep(500);
      assert.equal(await globe.state(), "running", garbage);
    }
    await globe.follow(COAST);
    const same = difference(fresh, await globe.picture());
    assert.equal(same.worst, 0, `after the garbage a good link gives another picture: ${JSON.stringify(same)}`);
    assert.deepEqual(globe.errors(), []);
    await globe.close();
  });
}
