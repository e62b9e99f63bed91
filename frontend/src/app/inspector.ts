import { isInspector } from "../protocol/guards.gen";
import type { Inspector } from "../store/inspector";
import { failureMessage } from "../store/messages";
import type { Rest } from "../transport/rest";

export function createInspector(rest: Rest): Inspector {
  return {
    read: async () => {
      const answer = await rest.ask("GET", "/api/v1/inspector", isInspector);
      return answer.ok ? answer.value : failureMessage(answer.problem);
    },
  };
}
