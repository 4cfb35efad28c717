// Starts the globe: looks for WebGPU first, loads the program with visible progress, and says in plain words what is missing.
// The state of the page stands in the `data-state` of <html>: loading, running, unsupported or failed.

const byId = (id) => document.getElementById(id);
const canvas = byId("globe");

/** What keeps this browser from drawing the globe, or null. */
async function whatIsMissing() {
  const title = "This globe needs WebGPU";
  if (!window.isSecureContext) {
    return {
      title,
      reason: "Browsers give WebGPU only to pages that come over https or from this very machine. This page came over plain http.",
      remedies: ["Open it under its https address, or on the machine that serves it as http://localhost."],
    };
  }
  if (!navigator.gpu) {
    return {
      title,
      reason: "This browser has no WebGPU, the way by which a web page uses the graphics card to draw and to compute.",
      remedies: [
        "Chrome or Edge: version 113 or newer (Android: 121 or newer).",
        "Safari: version 26 or newer. Firefox: version 141 or newer on Windows, 145 or newer on a Mac.",
        "On Linux, Chrome may need chrome://flags/#enable-unsafe-webgpu switched on.",
      ],
    };
  }
  const adapter = await navigator.gpu.requestAdapter().catch(() => null);
  if (!adapter) {
    return {
      title: "No graphics card for the globe",
      reason: "This browser knows WebGPU, but found no graphics card or driver that it trusts.",
      remedies: [
        "Switch on hardware acceleration in the browser's settings, then restart it.",
        "Update the graphics driver. The page chrome://gpu tells why WebGPU is off.",
        "On Linux, Chrome may need chrome://flags/#enable-unsafe-webgpu and #enable-vulkan switched on.",
      ],
    };
  }
  return null;
}

/** Shows a plain page in place of the globe. */
function showNotice(state, { title, reason, remedies, details = "" }) {
  if (document.documentElement.dataset.state === "unsupported") return;
  document.documentElement.dataset.state = state;
  canvas.hidden = byId("poster").hidden = true;
  byId("notice").querySelector("h1").textContent = title;
  byId("reason").textContent = reason;
  byId("details").textContent = details;
  byId("remedies").replaceChildren(...remedies.map((remedy) => Object.assign(document.createElement("li"), { textContent: remedy })));
  byId("notice").hidden = false;
}

/** Fetches the program; its compilation starts while it still arrives, and the bar shows how far it is. */
async function fetchProgram(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
  const length = Number(response.headers.get("Content-Length"));
  // The length of a compressed answer says nothing about the bytes that come out.
  if (length > 0 && !response.headers.has("Content-Encoding")) byId("progress").max = length;
  let received = 0;
  const count = new TransformStream({
    transform(chunk, controller) {
      received += chunk.byteLength;
      if (byId("progress").max > 1) byId("progress").value = received;
      controller.enqueue(chunk);
    },
  });
  return new Response(response.body.pipeThrough(count), { headers: response.headers });
}

/** Takes the poster away once the first picture is drawn. */
function showFirstPicture() {
  const observer = new MutationObserver(() => {
    if (!(canvas.dataset.pictures > 0)) return;
    observer.disconnect();
    if (document.documentElement.dataset.state === "loading") document.documentElement.dataset.state = "running";
  });
  observer.observe(canvas, { attributes: true, attributeFilter: ["data-pictures"] });
}

function fail(error) {
  // What the program reports as a text is on the console already.
  if (typeof error !== "string") console.error(error);
  showNotice("failed", {
    title: "The globe could not start",
    reason: "The program did not load, or it stopped. Your view is kept in the address of this page.",
    remedies: ["Reload the page.", "If that does not help, restart the browser: the graphics driver may have stopped."],
    details: String(error?.message ?? error),
  });
}

async function start() {
  const missing = await whatIsMissing();
  if (missing) return showNotice("unsupported", missing);
  // A panic of the program ends it for good; it reaches the page as an error of WebAssembly.
  addEventListener("error", ({ error }) => error instanceof WebAssembly.RuntimeError && fail(error));
  showFirstPicture();
  const program = byId("program");
  const [bindings, wasm] = await Promise.all([import(program.href), fetchProgram(program.dataset.wasm)]);
  await bindings.default({ module_or_path: wasm });
  byId("status").textContent = "Preparing the first picture …";
  byId("progress").removeAttribute("value");
  await bindings.start(canvas, new URL("data/", document.baseURI).href);
}

start().catch(fail);
