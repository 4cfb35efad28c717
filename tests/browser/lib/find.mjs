// Where a browser is on this machine. As a program, `node find.mjs firefox`: prints it, or fails; setup.sh asks this way.

import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";

const KNOWN = {
  firefox: { names: ["firefox-esr", "firefox"], onMacOs: ["Firefox.app/Contents/MacOS/firefox"] },
  chromium: {
    names: ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"],
    onMacOs: ["Google Chrome.app/Contents/MacOS/Google Chrome", "Chromium.app/Contents/MacOS/Chromium"],
  },
};

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** Path of `firefox` or `chromium`; what the environment's FIREFOX or CHROMIUM names goes before all others. */
export function findBrowser(browser) {
  const { names, onMacOs } = KNOWN[browser];
  const variable = browser.toUpperCase();
  const named = process.env[variable];
  const folders = (process.env.PATH ?? "").split(delimiter);
  const candidates = named
    ? [named]
    : [
        ...folders.flatMap((folder) => names.map((name) => join(folder, name))),
        ...onMacOs.map((path) => join("/Applications", path)),
      ];
  const found = candidates.find(isProgram);
  if (!found) throw new Error(`no ${browser} found: install it, or set ${variable}=/path/to/its/program`);
  return found;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) console.log(findBrowser(process.argv[2]));
