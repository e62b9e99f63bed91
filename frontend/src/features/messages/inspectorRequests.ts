import type { Inspection } from "../../protocol/contract";
import { isInspector } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

/** Statistics of the links, read by whoever shows them. */
export interface Inspector {
  /** The present statistics, or the message of the failure. */
  readonly read: () => Promise<Inspection | Message>;
}

export const INSPECTOR = partName<Inspector>("inspector");

export function createInspector(rest: Gateway): Inspector {
  return {
    read: async () => {
      const answer = await rest.ask("GET", "/api/v1/inspector", isInspector);
      return answer.ok ? answer.value : failureMessage(answer.problem);
    },
  };
}
