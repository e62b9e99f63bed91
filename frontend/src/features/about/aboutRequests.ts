import { type About, isAbout } from "../../protocol/guards.gen";
import type { RequesterParts } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

export interface AboutRequests {
  /** Versions and licences, or the message of the failure. */
  readonly read: () => Promise<About | Message>;
}

export const ABOUT = partName<AboutRequests>("about");

export function createAbout({ rest }: Pick<RequesterParts, "rest">): AboutRequests {
  return {
    read: async () => {
      const answer = await rest.ask("GET", "/api/v1/about", isAbout);
      return answer.ok ? answer.value : failureMessage(answer.problem);
    },
  };
}
