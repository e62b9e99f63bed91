import { isInspector } from "../../protocol/guards.gen";
import type { AskReplay } from "../../requests/streamQuestions";
import type { Inspector } from "./inspectorRequests";

/** The messages of a flight of the past up to the moment that is shown, as its replay counted them. */
export function createPastInspector(ask: AskReplay): Inspector {
  return {
    read: async () => {
      const answer = await ask("inspector");
      return isInspector(answer) ? answer : { level: "error", key: "messages.pastSilent", params: {} };
    },
  };
}
