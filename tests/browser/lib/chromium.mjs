// Where Chromium is on this machine. As a program: prints it, or fails; setup.sh asks this way.

import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";

const NAMES = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"];
const ON_MACOS = ["Google Chrome", "Chromium"].map((name) => `/Applications/${name}.app/Contents/MacOS/${name}`);

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** Path of the browser; the environment's CHROMIUM goes before all others. */
export function findChromium() {
  const { CHROMIUM, PATH = "" } = process.env;
  const candidates = CHROMIUM
    ? [CHROMIUM]
    : [...PATH.split(delimiter).flatMap((folder) => NAMES.map((name) => join(folder, name))), ...ON_MACOS];
  const found = candidates.find(isProgram);
  if (!found) throw new Error("no Chromium found: install it, or set CHROMIUM=/path/to/its/program");
  return found;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) console.log(findChromium());
