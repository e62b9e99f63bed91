/**
 * The page's service worker: keeps index.html and the page's own hashed files, so that an installed page starts while
 * the station cannot be reached, and says so. It never keeps an answer of the station, a value or a map: those requests
 * do not pass through it.
 *
 * The build puts two constants before this text: VERSION, made from the contents, and FILES, the paths that are kept.
 */
/* global VERSION, FILES */
const KEPT = "epf-page-";
const OWN = KEPT + VERSION;
/** After so long the kept index.html is shown: a network that is gone may never answer. */
const PATIENCE_MS = 4000;

self.addEventListener("install", (event) => {
  // Where the browser can, nothing but page and files wakes this worker.
  event.addRoutes?.({
    condition: { not: { or: [{ urlPattern: "/" }, { urlPattern: "/assets/*" }] } },
    source: "network",
  });
  event.waitUntil(caches.open(OWN).then((cache) => cache.addAll(FILES)));
});

self.addEventListener("activate", (event) => {
  event.waitUntil(removeOthers());
});

// A new version waits until the user wants it, or until no page of the old one is open.
self.addEventListener("message", ({ data }) => {
  if (data === "activate") {
    self.skipWaiting();
  }
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const { origin, pathname } = new URL(request.url);
  if (request.method !== "GET" || origin !== self.location.origin) {
    return;
  }
  if (request.mode === "navigate" && pathname === "/") {
    event.respondWith(page(request));
  } else if (pathname !== "/" && FILES.includes(pathname)) {
    event.respondWith(file(request, pathname));
  }
});

async function removeOthers() {
  const names = await caches.keys();
  await Promise.all(
    names.filter((name) => name.startsWith(KEPT) && name !== OWN).map((name) => caches.delete(name)),
  );
}

/** The station's own index.html while it can be reached, so that nobody stays with an old one by surprise. */
async function page(request) {
  const kept = await keptFile("/");
  try {
    return await fetch(request, kept === undefined ? {} : { signal: AbortSignal.timeout(PATIENCE_MS) });
  } catch (error) {
    if (kept === undefined) {
      throw error;
    }
    return kept;
  }
}

/** A hashed file is the same for ever. */
async function file(request, pathname) {
  return (await keptFile(pathname)) ?? fetch(request);
}

async function keptFile(pathname) {
  return (await caches.open(OWN)).match(pathname);
}
