// Chromium's compiler takes every shader, those of pipelines that no other test makes too. tests/gpu/shaders.rs leaves them composed
// in target/shaders.

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { PAGE } from "../lib/servers.mjs";

/** Shaders that are sent at once. */
const PART = 100;
const FOLDER = join(dirname(PAGE), "shaders");

export function shaderTests(site) {
  test("Chromium's compiler finds no fault with any shader", async (t) => {
    const names = (await readdir(FOLDER)).sort();
    assert.ok(names.length >= 26, `only ${names.length} shaders in ${FOLDER}: run tests/gpu/shaders.rs first`);
    const sources = await Promise.all(names.map((name) => readFile(join(FOLDER, name), "utf8")));
    const faults = [];
    // In parts: the browser closes a connection whose message is longer than 100 MB.
    for (let first = 0; first < sources.length + 1; first += PART) {
      const part = ["@compute fn", ...sources].slice(first, first + PART);
      faults.push(...(await site.globe.page.evaluate(async (sources) => {
        const device = await (await navigator.gpu.requestAdapter()).requestDevice();
        const compiled = async (code) => {
          const module = device.createShaderModule({ code });
          const { messages } = await module.getCompilationInfo();
          return messages.filter(({ type }) => type === "error").map(({ lineNum, message }) => `${code.split("\n")[lineNum - 1]}: ${message}`);
        };
        const found = await Promise.all(sources.map(compiled));
        device.destroy();
        return found;
      }, part)));
    }
    // The first is no shader at all: silence would be no praise.
    assert.ok(faults.shift().length > 0, "a broken shader was taken");
    assert.deepEqual(Object.fromEntries(names.map((name, i) => [name, faults[i]]).filter(([, found]) => found.length)), {});
    t.diagnostic(`${names.length} shaders`);
  });
}
