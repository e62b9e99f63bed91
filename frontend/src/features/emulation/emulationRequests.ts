import { type Asker, createAsking, info, type RequesterParts } from "../../requests/asking";
import { partName } from "../../store/parts";

const BOARD = "/api/v1/links/board";
/** The address of the link that plays example values. */
const EMULATION_URL = "emulation:";

/** Starts and ends the emulation; none throws. */
export interface EmulationRequests {
  readonly start: (asker: Asker) => Promise<void>;
  /** Reopen the link that was open before; if there was none, close the link. */
  readonly end: (before_url: string | null, asker: Asker) => Promise<void>;
}

export const EMULATION = partName<EmulationRequests>("emulation");

export function createEmulation(parts: RequesterParts): EmulationRequests {
  const { simply } = createAsking(parts);
  return {
    start: (asker) => simply(asker, ["PUT", BOARD, { url: EMULATION_URL }], info("said.emulationStarted")),
    end: (before_url, asker) =>
      before_url === null
        ? simply(asker, ["DELETE", BOARD], info("said.emulationEnded"))
        : simply(asker, ["PUT", BOARD, { url: before_url }], info("said.boardOpening", { url: before_url })),
  };
}
