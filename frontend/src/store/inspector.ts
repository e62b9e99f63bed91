import type { Inspection } from "../protocol/inspector";
import type { Message } from "./messages";

/** What went over the lines, asked for by whoever looks at it. */
export interface Inspector {
  /** All of it now, or why there is none. */
  readonly read: () => Promise<Inspection | Message>;
}
