import { browserSounder, browserSpeaker } from "../features/alarms/browserAlarms";
import { browserGamepads } from "../features/gamepad/browserGamepads";
import { BROWSER_TIMERS } from "../lib/timers";
import type { BrowserStorage } from "../store/settings";
import type { UploadInit } from "../transport/rest";
import type { Wire, WireListener } from "../transport/socket";
import { browserVersions } from "./pageVersion";
import type { World } from "./world";

/** How often the page is painted at most, in hertz. */
const RATE_HZ = 60;

/** What the page needs, taken from the browser's window. */
export function browserWorld(window: Window & typeof globalThis): World {
  return {
    timers: BROWSER_TIMERS,
    wall_ms: () => Date.now(),
    dial: (client, listener) => dial(window, client === null ? {} : { client }, listener),
    dialFlight: ({ flight, at_s }, listener) => dial(window, { flight, at_s: at_s.toFixed(3) }, listener),
    address: {
      read: () => window.location.href,
      replace: (address) => window.history.replaceState(null, "", address),
      onMoved: (run) => window.addEventListener("hashchange", run),
    },
    versions: browserVersions(window, import.meta.env.PROD),
    fetch: (path, init) => window.fetch(path, init),
    upload: (path, init) => upload(window, path, init),
    animationFrames: {
      request: (callback) => window.requestAnimationFrame(callback),
      cancel: (handle) => window.cancelAnimationFrame(handle),
      measure: animationFrameMeter(window),
    },
    saveFile: (name, content) => {
      const address = URL.createObjectURL(content);
      const link = window.document.createElement("a");
      link.href = address;
      link.download = name;
      link.click();
      // Not before the browser has begun to read it.
      window.setTimeout(() => URL.revokeObjectURL(address), 10_000);
    },
    report: (error) => window.reportError(error),
    gamepads: browserGamepads(window),
    storage: storageOf(() => window.localStorage),
    tabStorage: storageOf(() => window.sessionStorage),
    languages: window.navigator.languages,
    sounder: browserSounder(window),
    speaker: browserSpeaker(window, BROWSER_TIMERS),
  };
}

/** By the older interface: `fetch` does not tell how much of a body is sent. */
function upload(
  window: Window & typeof globalThis,
  path: string,
  { headers, body, onSent, signal }: UploadInit,
): Promise<Response> {
  return new Promise((resolve, reject) => {
    const request = new window.XMLHttpRequest();
    request.open("POST", path);
    for (const [name, value] of Object.entries(headers)) {
      request.setRequestHeader(name, value);
    }
    request.upload.addEventListener("progress", ({ loaded }) => onSent(loaded));
    request.addEventListener("load", () =>
      resolve(new Response(request.responseText, { status: request.status })),
    );
    for (const end of ["error", "abort", "timeout"]) {
      request.addEventListener(end, () => reject(new TypeError(end)));
    }
    signal.addEventListener("abort", () => request.abort());
    request.send(body);
  });
}

function dial(
  window: Window & typeof globalThis,
  query: Readonly<Record<string, string>>,
  { onMessage, onClose }: WireListener,
): Wire {
  const address = new URL("/api/v1/stream", window.location.href);
  address.search = "";
  address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
  for (const [name, value] of Object.entries({ rate: String(RATE_HZ), ...query })) {
    address.searchParams.set(name, value);
  }
  const socket = new WebSocket(address);
  socket.addEventListener("message", ({ data }) => onMessage(data));
  socket.addEventListener("close", onClose);
  return {
    send: (text) => socket.send(text),
    unsent_bytes: () => socket.bufferedAmount,
    close: () => socket.close(),
  };
}

/** Measures the cost of an animation frame: a message posted to oneself arrives after layout and paint. */
function animationFrameMeter(window: Window & typeof globalThis): (spent: (cost_ms: number) => void) => void {
  const { port1, port2 } = new window.MessageChannel();
  let begun_ms = 0;
  let tell: ((cost_ms: number) => void) | null = null;
  port1.onmessage = () => {
    tell?.(window.performance.now() - begun_ms);
    tell = null;
  };
  return (spent) => {
    begun_ms = window.performance.now();
    tell = spent;
    port2.postMessage(null);
  };
}

/** A browser that forbids storage throws when the property is read. */
function storageOf(storage: () => Storage): BrowserStorage | null {
  try {
    return storage();
  } catch {
    return null;
  }
}
