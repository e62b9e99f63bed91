import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { browserVersions } from "./pageVersion";

const REGISTERED_MS = 9000;

/** A worker as the browser shows it to the page. */
class SomeWorker extends EventTarget {
  readonly scriptURL: string;
  readonly told: unknown[] = [];
  state = "installing";

  constructor(path = "/sw.js") {
    super();
    this.scriptURL = `https://station.local${path}`;
  }

  postMessage(message: unknown): void {
    this.told.push(message);
  }

  become(state: string): void {
    this.state = state;
    this.dispatchEvent(new Event("statechange"));
  }
}

/** What the browser keeps about one worker. */
class Registration extends EventTarget {
  active: SomeWorker | null = null;
  waiting: SomeWorker | null = null;
  installing: SomeWorker | null = null;
  readonly unregister = vi.fn(() => Promise.resolve(true));
  readonly update = vi.fn((): Promise<void> => Promise.resolve());

  /** A newer file was found at the station. */
  find(worker: SomeWorker): void {
    this.installing = worker;
    this.dispatchEvent(new Event("updatefound"));
  }
}

class Workers extends EventTarget {
  controller: SomeWorker | null = null;
  /** Those of earlier visits. */
  known: Registration[] = [];
  readonly made = new Registration();
  readonly register = vi.fn((): Promise<Registration> => Promise.resolve(this.made));

  getRegistrations(): Promise<Registration[]> {
    return Promise.resolve(this.known);
  }
}

function browser(workers: Workers | undefined) {
  const reload = vi.fn();
  const window = { navigator: { serviceWorker: workers }, location: { reload }, setTimeout };
  return { reload, window: window as unknown as Window & typeof globalThis };
}

/** A page that has been open for a while, and the newer versions that it was offered. */
async function openPage(workers: Workers | undefined, isBuilt = true) {
  const { window, reload } = browser(workers);
  const versions = browserVersions(window, isBuilt);
  const offers: (() => void)[] = [];
  versions.onNewer((load) => offers.push(load));
  await vi.advanceTimersByTimeAsync(REGISTERED_MS);
  return { versions, offers, reload };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

describe("the page's worker", () => {
  test("is registered after the page has started, and its file is never taken from a cache", async () => {
    const workers = new Workers();
    const { window } = browser(workers);
    browserVersions(window, true).onNewer(() => undefined);
    await vi.advanceTimersByTimeAsync(1000);
    expect(workers.register).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(REGISTERED_MS);
    expect(workers.register).toHaveBeenCalledExactlyOnceWith("/sw.js", { updateViaCache: "none" });
  });

  test("is not registered without a build, and one of an earlier build is removed", async () => {
    const workers = new Workers();
    const old = new Registration();
    old.active = new SomeWorker();
    workers.known = [old];
    await openPage(workers, false);
    expect(old.unregister).toHaveBeenCalledOnce();
    expect(workers.register).not.toHaveBeenCalled();
  });

  test("replaces those of other names, in whatever state they are, and keeps its own", async () => {
    const workers = new Workers();
    const [own, active, waiting, installing, empty] = Array.from({ length: 5 }, () => new Registration()) as [
      Registration,
      Registration,
      Registration,
      Registration,
      Registration,
    ];
    own.active = new SomeWorker();
    active.active = new SomeWorker("/old.js");
    waiting.waiting = new SomeWorker("/old.js");
    installing.installing = new SomeWorker("/old.js");
    workers.known = [own, active, waiting, installing, empty];
    await openPage(workers);
    expect(workers.known.map(({ unregister }) => unregister.mock.calls.length)).toEqual([0, 1, 1, 1, 0]);
    expect(workers.register).toHaveBeenCalledOnce();
  });
});

describe("a page in a browser that allows no worker", () => {
  test("works without one, and looking for a newer version does nothing", async () => {
    const { versions, offers } = await openPage(undefined);
    expect(() => versions.look()).not.toThrow();
    expect(offers).toEqual([]);
  });

  test("works although the worker is refused", async () => {
    const workers = new Workers();
    workers.register.mockRejectedValue(new Error("refused"));
    const { versions, offers } = await openPage(workers);
    expect(() => versions.look()).not.toThrow();
    expect(offers).toEqual([]);
  });
});

describe("a newer version", () => {
  test("is offered when it is complete, and not while it is still being fetched", async () => {
    const workers = new Workers();
    workers.controller = new SomeWorker();
    const { offers } = await openPage(workers);
    const newer = new SomeWorker();
    workers.made.find(newer);
    expect(offers).toHaveLength(0);
    newer.become("installed");
    expect(offers).toHaveLength(1);
    newer.become("activating");
    expect(offers).toHaveLength(1);
  });

  test("that was complete before the page was opened is offered too", async () => {
    const workers = new Workers();
    workers.controller = new SomeWorker();
    workers.made.waiting = new SomeWorker();
    expect((await openPage(workers)).offers).toHaveLength(1);
  });

  test("is no news to a page that came from the station and not from a worker", async () => {
    const workers = new Workers();
    workers.made.waiting = new SomeWorker();
    const { offers } = await openPage(workers);
    const newer = new SomeWorker();
    workers.made.find(newer);
    newer.become("installed");
    expect(offers).toEqual([]);
  });

  test("is shown only once it has been accepted and has taken over", async () => {
    const workers = new Workers();
    workers.controller = new SomeWorker();
    const newer = new SomeWorker();
    workers.made.waiting = newer;
    const { offers, reload } = await openPage(workers);
    workers.dispatchEvent(new Event("controllerchange"));
    expect(newer.told).toEqual([]);
    expect(reload).not.toHaveBeenCalled();
    offers[0]?.();
    expect(newer.told).toEqual(["activate"]);
    expect(reload).not.toHaveBeenCalled();
    workers.dispatchEvent(new Event("controllerchange"));
    workers.dispatchEvent(new Event("controllerchange"));
    expect(reload).toHaveBeenCalledOnce();
  });

  test("is looked for at the station on request, and a station that is away is no fault", async () => {
    const workers = new Workers();
    const { window } = browser(workers);
    const versions = browserVersions(window, true);
    versions.onNewer(() => undefined);
    versions.look();
    expect(workers.made.update).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(REGISTERED_MS);
    workers.made.update.mockRejectedValue(new Error("away"));
    versions.look();
    await vi.advanceTimersByTimeAsync(0);
    expect(workers.made.update).toHaveBeenCalledOnce();
  });
});
