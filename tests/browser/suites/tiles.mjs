// The world streams in from servers good and bad.

import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { Globe } from "../lib/browser.mjs";
import { colourAt, difference, kindOf } from "../lib/picture.mjs";
import { startBreakable } from "../lib/servers.mjs";
import { COAST, FROM_ORBIT } from "../lib/views.mjs";

const garbage = (bytes) => bytes.map((byte, index) => byte ^ (index * 37 + 11));

export const tileTests = (site) => describe("tiles", () => {
  let whole;
  before(async () => {
    whole = await coastFrom(await startBreakable());
  });

  /** The picture of the coast from a server, and what the page asked it for. */
  async function coastFrom(server) {
    try {
      const globe = await Globe.open(site.browser, server.address, { fragment: COAST, query: "?panel=off" });
      await globe.settled();
      const picture = await globe.picture();
      assert.deepEqual(globe.errors(), []);
      await globe.close();
      return { picture, requests: server.requests.filter(({ path }) => path.endsWith(".pmtiles")) };
    } finally {
      server.close();
    }
  }

  test("tiles come by ranges, a small part of the archives", () => {
    assert.ok(whole.requests.length > 0);
    assert.deepEqual(whole.requests.filter(({ range }) => !range), []);
  });

  test("the opening view in full HD takes few requests, and no tile twice", async (t) => {
    const server = await startBreakable();
    const globe = await Globe.open(site.browser, server.address, { size: [1920, 1080] });
    try {
      await globe.settled();
      assert.deepEqual(globe.errors(), []);
    } finally {
      await globe.close();
      server.close();
    }
    const parts = server.requests.filter(({ range }) => range);
    const megabytes = server.requests.reduce((sum, { bytes }) => sum + bytes, 0) / 1e6;
    t.diagnostic(`${server.requests.length} requests, ${megabytes.toFixed(1)} MB, ${parts.length} of them for parts of archives: ${JSON.stringify(bytesOf(parts))}`);
    noneTwice(parts);
    // Each tile on its own were 134 requests.
    assert.ok(parts.length > 5 && parts.length <= 67, `${parts.length} requests for parts of archives`);
    // Coasts as texels of the same tiles were 1.03 MB; as lines they are .4.
    const coasts = bytesOf(parts)["/data/water.pmtiles"];
    assert.ok(coasts > 0 && coasts < 1e6, `${coasts} bytes of coasts`);
  });

  test("what came with its neighbours, or as its twin, is not fetched again when it is wanted", async (t) => {
    // As over a real line: wishes come while others are on their way.
    let turn = 0;
    const server = await startBreakable({ delay: (path) => (path.endsWith(".pmtiles") ? (turn++ * 89) % 300 : 0) });
    const globe = await Globe.open(site.browser, server.address, { fragment: "#view=10,-150,9000000", query: "?panel=off" });
    try {
      for (const view of ["0,-150,9000000", "20,-120,6000000", "-20,160,6000000"]) await globe.follow(`#view=${view}`);
      assert.deepEqual(globe.errors(), []);
    } finally {
      await globe.close();
      server.close();
    }
    const parts = server.requests.filter(({ range }) => range);
    t.diagnostic(`${parts.length} requests for parts of archives: ${JSON.stringify(bytesOf(parts))}`);
    noneTwice(parts);
  });

  /** Bytes of each archive that were asked for. */
  function bytesOf(parts) {
    const bytes = {};
    for (const part of parts) bytes[part.path] = (bytes[part.path] ?? 0) + part.bytes;
    return bytes;
  }

  /** Asserts that no byte of an archive was asked for twice. */
  function noneTwice(parts) {
    // An archive's head is read before anybody knows where it ends: its 6 kB may reach into the first tiles.
    const ends = parts.map(({ path, range }) => [path, ...range.match(/\d+/g).map(Number)]).filter(([, first]) => first > 0);
    ends.sort(([path, first], [otherPath, otherFirst]) => path.localeCompare(otherPath) || first - otherFirst);
    for (const [i, [path, first]] of ends.entries()) {
      const [pathBefore, , lastBefore] = ends[i - 1] ?? [];
      assert.ok(path !== pathBefore || first > lastBefore, `${path}: ${lastBefore} comes twice`);
    }
  }

  test("a server without ranges gives the same picture, each archive fetched once", async () => {
    const { picture, requests } = await coastFrom(await startBreakable({ ranges: false }));
    const same = difference(whole.picture, picture);
    assert.equal(same.worst, 0, JSON.stringify(same));
    const paths = requests.map(({ path }) => path);
    assert.ok(paths.length <= 2 * new Set(paths).size, `asked too often for whole archives: ${paths}`);
  });

  for (const [name, broken] of Object.entries({ "answers 500": 500, "sends garbage": garbage })) {
    test(`a tile server that ${name} leaves the parents' picture and one clear line in the console`, async (t) => {
      const server = await startBreakable();
      // Left open by a failure, it would keep the whole run from ending.
      t.after(() => server.close());
      const globe = await Globe.open(site.browser, server.address, { fragment: FROM_ORBIT, query: "?panel=off" });
      await globe.settled();
      const before = globe.console.length;
      server.behaviour.answer = (path) => (path.endsWith(".pmtiles") ? broken : undefined);
      await globe.follow(COAST);

      const picture = await globe.picture();
      // Between the towns about Lisbon, whose grey roofs the haze makes blue.
      const [west, east] = [colourAt(picture, 0.1, 0.5), colourAt(picture, 0.9, 0.38)];
      assert.equal(kindOf(west), "sea", `west: ${west}`);
      assert.equal(kindOf(east), "land", `east: ${east}`);
      assert.equal(await globe.state(), "running");

      const lines = globe.console.slice(before).map(({ text }) => text);
      assert.ok(lines.some((text) => /tile|pmtiles/i.test(text)), `no line says which tile: ${lines.join("\n")}`);
      assert.equal(new Set(lines).size, lines.length, `the same line again and again:\n${lines.join("\n")}`);
      assert.ok(!lines.some((text) => /panicked|uncaught/.test(text)), lines.join("\n"));
      await globe.close();
    });
  }
});
