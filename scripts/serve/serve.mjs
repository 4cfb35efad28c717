// Serves a folder on this machine with HTTP range requests: node serve.mjs FOLDER [PORT], port 0 for any free one.

import { createServer } from "node:http";
import sirv from "sirv";

const [folder, port = "8080"] = process.argv.slice(2);
// A browser asks every time whether a file has changed (`etag`), and a page that is built anew is served at once (`dev`).
const files = sirv(folder, { dev: true, etag: true });
const server = createServer((request, response) => files(request, response));
server.on("error", ({ message }) => {
  console.error(`Cannot serve: ${message}\n  What to do: choose another port, as in PORT=9000 make run`);
  process.exit(1);
});
server.listen(Number(port), "127.0.0.1", () => {
  console.log(`Serving ${folder} on http://127.0.0.1:${server.address().port}/ (Ctrl-C ends it)`);
});
