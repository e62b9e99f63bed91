import { isAbout } from "../protocol/guards.gen";
import { EMULATION_URL, type FrameActions } from "../store/frame";
import { failureMessage } from "../store/messages";
import { type AskingParts, createAsking, info } from "./asking";

const BOARD = "/api/v1/links/board";

export function createFrameActions(parts: AskingParts): FrameActions {
  const { simply } = createAsking(parts);
  return {
    startEmulation: (asker) =>
      simply(asker, ["PUT", BOARD, { url: EMULATION_URL }], info("said.emulationStarted")),
    endEmulation: (before_url, asker) =>
      before_url === null
        ? simply(asker, ["DELETE", BOARD], info("said.emulationEnded"))
        : simply(asker, ["PUT", BOARD, { url: before_url }], info("said.boardOpening", { url: before_url })),
    resetTrack: (asker) => simply(asker, ["POST", "/api/v1/track/reset"], info("said.trackReset")),
    restoreTrack: (asker) => simply(asker, ["POST", "/api/v1/track/restore"], info("said.trackRestored")),
    readAbout: async () => {
      const answer = await parts.rest.ask("GET", "/api/v1/about", isAbout);
      return answer.ok ? answer.value : failureMessage(answer.problem);
    },
  };
}
