// The page on loopback: by the program's own server, by that of make run, or by one that can be told to misbehave.

import { spawn } from "node:child_process";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { setTimeout as sleep } from "node:timers/promises";
import { extname, join, normalize, resolve, sep } from "node:path";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../../", import.meta.url));

/** Folder of the built page. */
export const PAGE = resolve(ROOT, process.env.OCEAN_GLOBE_PAGE ?? "target/page");
/** The native program. */
export const PROGRAM = resolve(ROOT, process.env.OCEAN_GLOBE ?? "target/debug/ocean-globe");

/** `ocean-globe serve` on a free port: its address and how to end it. */
export const startProduct = () => startProgram(PROGRAM, ["serve", PAGE, "--port", "0"]);

/** The server of `make run`, likewise. */
export const startServer = () => startProgram(process.execPath, [join(ROOT, "scripts/serve/serve.mjs"), PAGE, "0"]);

async function startProgram(program, args) {
  const child = spawn(program, args, { stdio: ["ignore", "pipe", "inherit"] });
  const address = await new Promise((resolve, reject) => {
    let text = "";
    child.stdout.on("data", (chunk) => {
      text += chunk;
      const found = text.match(/http:\/\/\S+/);
      if (found) resolve(found[0]);
    });
    child.on("error", reject);
    child.on("exit", (code) => reject(new Error(`${program} ended with ${code}: ${text}`)));
  });
  return { address, close: () => child.kill() };
}

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".wasm": "application/wasm" };

/**
 * A server of the same folder that a test can break while the page runs.
 *
 * `behaviour.ranges = false`: answers every request with the whole file. `behaviour.answer(path, range)`: returns `undefined`
 * to serve as usual, a number for an answer of that status, or a function that makes other bytes out of the right ones.
 * `behaviour.delay(path)`: milliseconds before the answer.
 */
export async function startBreakable(behaviour = {}) {
  const requests = [];
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname).replace(/\/$/, "/index.html");
    const range = request.headers.range;
    const special = behaviour.answer?.(path, range);
    const file = normalize(join(PAGE, path));
    const bytes = file.startsWith(PAGE + sep) ? await readFile(file).catch(() => null) : null;
    const status = typeof special === "number" ? special : bytes ? 200 : 404;
    const asked = { path, range, status, bytes: 0 };
    requests.push(asked);
    await sleep(behaviour.delay?.(path) ?? 0);
    if (status !== 200) return response.writeHead(status).end();
    const headers = { "Content-Type": TYPES[extname(file)] ?? "application/octet-stream", "Cache-Control": "no-store" };
    const change = special ?? ((same) => same);
    const [, first, last] = (behaviour.ranges !== false && range?.match(/^bytes=(\d+)-(\d+)$/)) || [];
    if (first === undefined) {
      const body = change(bytes);
      asked.bytes = body.length;
      return response.writeHead(200, { ...headers, "Content-Length": body.length }).end(body);
    }
    const body = change(bytes.subarray(Number(first), Number(last) + 1));
    asked.bytes = body.length;
    headers["Content-Range"] = `bytes ${first}-${Number(first) + body.length - 1}/${bytes.length}`;
    response.writeHead(206, { ...headers, "Content-Length": body.length }).end(body);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const close = () => {
    server.closeAllConnections();
    server.close();
  };
  return { address: `http://127.0.0.1:${server.address().port}/`, requests, behaviour, close };
}
