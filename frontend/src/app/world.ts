import type { Sounder, Speaker } from "../features/alarms/alarmLog";
import type { GamepadReader } from "../features/gamepad/gamepadList";
import type { AddressLine, PlaceInTime } from "../features/playback/flightAddress";
import type { AnimationFrames, Timers } from "../lib/timers";
import type { BrowserStorage } from "../store/settings";
import type { UploadInit } from "../transport/rest";
import type { Wire, WireListener } from "../transport/socket";
import type { PageVersions } from "./pageVersion";

/** What the page needs from outside: given by a browser's window, or by a test. */
export interface World {
  readonly timers: Timers;
  readonly wall_ms: () => number;
  readonly dial: (client: string | null, listener: WireListener) => Wire;
  /** Connects to the stream of a flight of the past, from a moment on. */
  readonly dialFlight: (place: PlaceInTime, listener: WireListener) => Wire;
  readonly fetch: (path: string, init: RequestInit) => Promise<Response>;
  readonly upload: (path: string, init: UploadInit) => Promise<Response>;
  readonly animationFrames: AnimationFrames;
  /** `storage` outlives the browser; `tabStorage` lasts until this browser tab is closed. */
  readonly storage: BrowserStorage | null;
  readonly tabStorage: BrowserStorage | null;
  /** The languages that the browser's user prefers, the first one most: `es-ES`. */
  readonly languages: readonly string[];
  readonly sounder: Sounder;
  readonly speaker: Speaker;
  readonly gamepads: GamepadReader;
  /** `onMoved` is called when somebody changes what stands behind the number sign. */
  readonly address: AddressLine & { readonly onMoved: (run: () => void) => void };
  readonly versions: PageVersions;
  /** Saves a file on the user's computer. */
  readonly saveFile: (name: string, content: Blob) => void;
  /** Reports an exception in the page's own code: to the browser's console. */
  readonly report: (error: unknown) => void;
}
