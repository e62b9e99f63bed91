import { test as base, type ConsoleMessage, expect, type Page } from "@playwright/test";
import { Station } from "./station.js";
import { ANY_STATION } from "./there.js";

type Fixtures = {
  /** A station that is up, with both links closed. */
  station: Station;
  /** How the station's board is started: `--legacy` makes it one without extensions, as deployed boards are. */
  boardOptions: readonly string[];
  /** Whether browsers of this computer need no key; false makes all of them strangers. */
  trustsThisComputer: boolean;
  /** Whether the station was never set up: its page asks for that first. */
  isNew: boolean;
  /** A station whose aircraft flies the Gando route. */
  flying: Station;
  /** Closes what a journey left open. */
  leftOpen: undefined;
};

/** One station for all journeys of a worker that serve with any, started when the first of them comes. */
class SharedStation {
  private station: Station | undefined;

  async take(): Promise<Station> {
    if (this.station === undefined) this.station = await Station.start();
    else await this.station.land();
    return this.station;
  }

  async stop(): Promise<void> {
    await this.station?.stop();
  }
}

/** Answers of a station whose flight process is away, or is not ready yet. */
const NOT_NOW = new Set(["409", "502", "503"]);

/**
 * What Chromium says by itself while the journey has taken the gateway away: it has a word for each moment at which an
 * answer can break off, and its service worker has others. What the page says has arguments.
 */
function isOfGatewayAway(message: ConsoleMessage): boolean {
  const text = message.text();
  if (/Failed to fetch dynamically imported module|Unable to preload CSS/.test(text)) return true;
  const status = /server responded with a status of (\d+)/.exec(text)?.[1];
  return message.args().length === 0 && (status === undefined || NOT_NOW.has(status));
}

/** Without a graphics processor the browser reads each 3D picture back by itself, and complains that this is slow. */
const READ_BACK = /GPU stall due to ReadPixels/;

/** What Chromium says of itself while the processor alone draws a globe. */
const SLOW_GRAPHICS = /GL Driver Message \(OpenGL, Performance/;

/**
 * The journeys' test: any console error, any exception in the page and any request that leaves the gateway fails it.
 */
export const test = base.extend<Fixtures, { shared: SharedStation }>({
  shared: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads from it which fixtures are needed
    async ({}, use) => {
      const shared = new SharedStation();
      await use(shared);
      await shared.stop();
    },
    { scope: "worker" },
  ],

  boardOptions: [[], { option: true }],
  trustsThisComputer: [true, { option: true }],
  isNew: [false, { option: true }],

  station: async ({ boardOptions, trustsThisComputer, isNew, shared }, use, info) => {
    const there = await Station.there();
    if (there !== undefined || info.tags.includes(ANY_STATION)) {
      await use(there ?? (await shared.take()));
      return;
    }
    const station = await Station.start(boardOptions, trustsThisComputer, isNew);
    await use(station);
    await station.stop();
  },

  // A page that a journey opened beside its own would go on looking for its station through all journeys after it.
  leftOpen: [
    async ({ browser }, use) => {
      await use(undefined);
      await Promise.all(browser.contexts().map((context) => context.close()));
    },
    { auto: true },
  ],

  flying: async ({ station }, use) => {
    await station.fly();
    await use(station);
  },

  context: async ({ context, station }, use, info) => {
    if (station.session !== undefined) await context.addCookies([station.session]);
    const complaints: string[] = [];
    const away = info.tags.includes("@gateway-away");
    // A problem answer to a wrong request is what such a journey is about; the browser logs each on its own.
    const refused = info.tags.includes("@refused");
    context.on("console", (message) => {
      if (message.type() !== "error" && message.type() !== "warning") return;
      if (SLOW_GRAPHICS.test(message.text())) return;
      if (away && isOfGatewayAway(message)) return;
      if (refused && /the server responded with a status of 4\d\d/.test(message.text())) return;
      if (READ_BACK.test(message.text())) return;
      complaints.push(`${message.type()}: ${message.text()} (${message.location().url})`);
    });
    // Most journeys are of the tabs that were there first: one of them is open at the first visit.
    await context.addInitScript(() => {
      const key = "epf-gcs.settings";
      // An empty page, before the first address, has no storage.
      if (location.protocol.startsWith("http") && localStorage.getItem(key) === null)
        localStorage.setItem(key, '{"choices":{"tab":"flight"}}');
    });
    context.on("weberror", (error) => complaints.push(`${error.error()}`));
    const watch = (asked: { url(): string }): void => {
      const url = asked.url();
      if (/^(https?|wss?):/.test(url) && new URL(url).host !== new URL(station.url).host) {
        complaints.push(`request that leaves the gateway: ${url}`);
      }
    };
    // Event streams are among the requests; a WebSocket is told of by its page alone.
    context.on("request", watch);
    context.on("page", (page) => page.on("websocket", watch));
    await use(context);
    expect(complaints, "console, exceptions and foreign requests").toEqual([]);
  },
});

export { expect };

/** Open the station's page and wait until it is live. */
export async function open(page: Page, station: Station): Promise<void> {
  await page.goto(station.url, { waitUntil: "domcontentloaded" });
  await expect(page.getByRole("heading", { name: "EPF GCS" })).toBeVisible();
}

/** The attitude indicator, which tells what it shows in attributes. */
export function attitude(page: Page) {
  return page.getByRole("img", { name: "Indicador de actitud" });
}
