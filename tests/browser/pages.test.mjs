// The page in real browsers, two at a time: each waits more than it works. Firefox draws with the same software as the native program and is several times
// faster than Chromium, so it has the whole suite; Chromium has what is its own: its compiler of shaders, its start and its pictures,
// from the server of make run.

import { describe } from "node:test";
import { startBreakable, startServer } from "./lib/servers.mjs";
import { visit } from "./lib/site.mjs";
import { linkTests } from "./suites/links.mjs";
import { noticeTests } from "./suites/notices.mjs";
import { panelTests } from "./suites/panel.mjs";
import { samePictureTests } from "./suites/same-picture.mjs";
import { sampleSurfaceTests } from "./suites/sample-surface.mjs";
import { shaderTests } from "./suites/shaders.mjs";
import { serverTests } from "./suites/server.mjs";
import { sheetTests } from "./suites/sheets.mjs";
import { startTests } from "./suites/start.mjs";
import { tileTests } from "./suites/tiles.mjs";

function suites(browser, options, all) {
  describe(browser, { concurrency: 1 }, () => {
    const site = visit(browser, options);
    for (const tests of all) tests(site);
  });
}

describe("browsers", { concurrency: 2 }, () => {
  suites("firefox", {}, [startTests, samePictureTests, sheetTests, sampleSurfaceTests, linkTests, panelTests, tileTests, serverTests]);
  suites("chromium", { start: startServer }, [startTests, samePictureTests, shaderTests, serverTests]);
  suites("chromium without WebGPU", { start: startBreakable }, [noticeTests]);
});
