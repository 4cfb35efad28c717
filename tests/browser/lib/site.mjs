// One server and one browser for all tests of a file.

import { after, before } from "node:test";
import { Globe, launch } from "./browser.mjs";
import { startProduct } from "./servers.mjs";

/**
 * The site that the tests of a file visit: by the program's own server unless `start` is another. `first(site)` comes before the
 * tests; a hook of the file's own would not wait for the server.
 */
export function visit({ start = startProduct, webgpu = true, first } = {}) {
  const site = {
    /** The globe in a page of its own; options as for `Globe.open`. */
    open: (options) => Globe.open(site.browser, site.server.address, options),
    /** The globe of a link, without its panel. */
    openLink: (fragment, size) => site.open({ fragment, size, query: "?panel=off" }),
  };
  before(async () => {
    site.server = await start();
    site.browser = await launch({ webgpu });
    await first?.(site);
  });
  after(async () => {
    await site.browser?.close();
    site.server?.close();
  });
  return site;
}
