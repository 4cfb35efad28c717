// Puts the quick page together from www/ and what wasm-bindgen made, as Trunk does for visitors (Trunk.toml), but without hashes in
// names: compiling Trunk would take longer than the page. node assemble.mjs FOLDER, where FOLDER holds ocean-globe.js and its wasm.

import { cpSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [folder] = process.argv.slice(2);
const [, pattern] = readFileSync("Trunk.toml", "utf8").match(/^pattern_script = '(.*)'$/m);
const names = { base: "./", js: "ocean-globe.js", wasm: "ocean-globe_bg.wasm" };
const program = pattern.replace(/\{(\w+)\}/g, (_, name) => names[name]);

for (const name of ["boot.js", "data", "icon.svg", "page.css"]) cpSync(join("www", name), join(folder, name), { recursive: true });
const page = readFileSync("www/index.html", "utf8")
  .replace(/<link data-trunk rel="copy-dir"[^>]*>\s*/, "")
  .replace(/<link data-trunk rel="rust"[^>]*>/, program)
  .replace('rel="css"', 'rel="stylesheet"')
  .replace('<link data-trunk rel="stylesheet"', '<link rel="stylesheet"')
  .replace('<link data-trunk rel="icon"', '<link rel="icon"')
  .replaceAll("<script data-trunk ", "<script ");
if (page.includes("trunk")) throw new Error("www/index.html asks Trunk for something that scripts/assemble.mjs does not know");
writeFileSync(join(folder, "index.html"), page);
