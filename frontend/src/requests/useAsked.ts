import { useSentence } from "../i18n/useSentence";
import type { CommandState } from "../store/commands";
import { useCommandEntry } from "../store/hooks";

export interface Asked {
  readonly state: CommandState;
  /** A sentence for an outcome that needs one: why it was refused. */
  readonly stateText: string | undefined;
  /** The requested position until it is proven. */
  readonly wanted: string | null;
}

/** The state of a control's newest command. */
export function useAsked(control: string): Asked {
  const sentence = useSentence();
  const entry = useCommandEntry(control);
  return {
    state: entry?.state ?? "idle",
    stateText: entry?.message ? sentence(entry.message) : undefined,
    wanted: entry?.state === "pending" ? entry.asked : null,
  };
}
