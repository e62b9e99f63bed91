import { isDone } from "../../protocol/answers";
import type { StreamEvent } from "../../protocol/envelope";
import type { Gateway } from "../../requests/asking";
import { failureMessage } from "../../store/messages";
import { type BoardConsole, clearConsole, createConsole, note } from "./consoleLog";

interface Parts {
  readonly rest: Gateway;
  readonly wall_ms: () => number;
}

/** The raw line: both directions are reported by the stream, so that every browser shows the same. */
export function createBoardConsole({ rest, wall_ms }: Parts): {
  readonly boardConsole: BoardConsole;
  readonly takeEvent: (event: StreamEvent) => void;
} {
  const store = createConsole();
  return {
    boardConsole: {
      store,
      send: async (text) => {
        const answer = await rest.ask("POST", "/api/v1/console", isDone, { text });
        return answer.ok ? null : failureMessage(answer.problem);
      },
      clear: () => clearConsole(store),
    },
    takeEvent: ({ event, data }) => {
      if (event === "console") {
        note(store, { direction: data.direction, text: data.text, at_ms: wall_ms() });
      }
    },
  };
}
