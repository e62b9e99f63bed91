import type { GainState } from "../../protocol/guards.gen";

export type Filter = "all" | "default" | "changed";

/** Whether a gain with this default is shown: all, those other than it, or those changed since the load. */
export function passes(
  filter: Filter,
  { value, loaded }: Pick<GainState, "value" | "loaded">,
  standard: number,
): boolean {
  switch (filter) {
    case "all":
      return true;
    case "default":
      return value !== null && value !== standard;
    case "changed":
      return value !== null && loaded !== null && value !== loaded;
  }
}
