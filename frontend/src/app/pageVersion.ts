/** Versions of the page as its service worker finds them. */
export interface PageVersions {
  /** Called when a newer version is complete in the browser; `load` shows it. Nothing changes before that. */
  readonly onNewer: (hear: (load: () => void) => void) => void;
  /** Look for one: the station may have been brought up to date. */
  readonly look: () => void;
}

const WORKER = "/sw.js";
/** After the page's start and the loading of its parts. */
const REGISTER_MS = 8000;

/**
 * Registers the worker where the browser allows one (https, and the station's own computer) and offers what it finds.
 * `isBuilt`: without a build there is no worker, and one of an earlier build is removed.
 */
export function browserVersions(window: Window & typeof globalThis, isBuilt: boolean): PageVersions {
  const { navigator } = window;
  const workers: ServiceWorkerContainer | undefined = navigator.serviceWorker;
  let registration: ServiceWorkerRegistration | null = null;
  let tell: (load: () => void) => void = () => undefined;
  // A page that an older worker serves may be offered a newer one; the very first worker is no news.
  const isServed = (): boolean => workers?.controller != null;

  function offer(waiting: ServiceWorker | null): void {
    if (waiting === null || !isServed()) {
      return;
    }
    tell(() => {
      workers?.addEventListener("controllerchange", () => window.location.reload(), { once: true });
      waiting.postMessage("activate");
    });
  }

  async function register(): Promise<void> {
    for (const other of (await workers?.getRegistrations()) ?? []) {
      const worker = other.active ?? other.waiting ?? other.installing;
      if (!isBuilt || (worker !== null && new URL(worker.scriptURL).pathname !== WORKER)) {
        await other.unregister();
      }
    }
    if (!isBuilt || workers === undefined) {
      return;
    }
    const made = await workers.register(WORKER, { updateViaCache: "none" });
    registration = made;
    offer(made.waiting);
    made.addEventListener("updatefound", () => {
      const { installing } = made;
      installing?.addEventListener("statechange", () => {
        if (installing.state === "installed") {
          offer(installing);
        }
      });
    });
  }

  return {
    onNewer: (hear) => {
      tell = hear;
      // Without a worker the page works as well; it cannot start while the station is away.
      window.setTimeout(() => void register().catch(() => undefined), REGISTER_MS);
    },
    look: () => void registration?.update().catch(() => undefined),
  };
}
