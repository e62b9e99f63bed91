import type { About } from "../protocol/guards.gen";
import type { Asker } from "./actions";
import type { Message } from "./messages";

/** The address of the link that plays example values. */
export const EMULATION_URL = "emulation:";

/** What the window's menus ask of the gateway beyond commands; as with `Actions`, none throws. */
export interface FrameActions {
  readonly startEmulation: (asker: Asker) => Promise<void>;
  /** Back to the line that was open before; without one the line is closed. */
  readonly endEmulation: (before_url: string | null, asker: Asker) => Promise<void>;
  readonly resetTrack: (asker: Asker) => Promise<void>;
  readonly restoreTrack: (asker: Asker) => Promise<void>;
  /** What the gateway is made of, or the sentence that says why it does not tell. */
  readonly readAbout: () => Promise<About | Message>;
}
