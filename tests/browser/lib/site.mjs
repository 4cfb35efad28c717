// What the tests of one browser share: the browser, a server, and a page that goes from link to link.

import { after, before } from "node:test";
import { Globe, launch } from "./browser.mjs";
import { startProduct } from "./servers.mjs";

/** The site that tests visit with `browser`, for the `describe` that calls this: by the program's own server unless `start` is another. */
export function visit(browser, { start = startProduct } = {}) {
  const pictures = new Map();
  const site = {
    browserName: browser,
    /** The globe in a page of its own; options as for `Globe.open`. Its tab is the one in front, which alone draws. */
    open: (options) => Globe.open(site.browser, site.server.address, options),
    /** The globe of a link, without its panel, in a page of its own. */
    openLink: (fragment, size, prepare) => site.open({ fragment, size, query: "?panel=off", prepare }),
    /**
     * The globe of a link, settled and without its panel, in the page that all tests share: compiling every pipeline for a new page
     * costs more than drawing. Leave it open, and at the link.
     */
    async show(fragment, size = [640, 360]) {
      site.globe ??= await site.openLink(fragment, size);
      await site.globe.page.bringToFront();
      await site.globe.resize(size);
      if (site.shown !== undefined && site.shown !== fragment) await site.globe.follow(fragment);
      else await site.globe.settled();
      site.shown = fragment;
      return site.globe;
    },
    /** The picture that `show` gives; taken once, whoever asks. */
    pictureOf(fragment, size) {
      const key = `${size} ${fragment}`;
      if (!pictures.has(key)) pictures.set(key, site.show(fragment, size).then((globe) => globe.picture()));
      return pictures.get(key);
    },
  };
  before(async () => {
    site.server = await start();
    site.browser = await launch(browser);
  });
  after(async () => {
    await site.browser?.close();
    site.server?.close();
  });
  return site;
}
