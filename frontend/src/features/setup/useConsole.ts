import { useSyncExternalStore } from "react";
import { usePage, usePart } from "../../store/hooks";
import type { ConsoleLog } from "./consoleLog";
import { BOARD_CONSOLE } from "./consoleLog";

/** The raw line's log, read ten times a second: a fast board must not render for each line. */
export function useConsole(): ConsoleLog {
  const { pump } = usePage();
  const boardConsole = usePart(BOARD_CONSOLE);
  return useSyncExternalStore(pump.onTick, () => boardConsole.store.getState());
}
