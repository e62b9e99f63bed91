import type { StreamEvent } from "../../protocol/envelope";
import type { RequesterParts } from "../../requests/asking";
import type { KnownAt } from "../../requests/knownAt";
import { createParameterActions, takeParameterEvent } from "./parameterRequests";
import { createParameters, forget, type ParameterActions, take } from "./parameterValues";

/** The gains as they were known at the moment of a flight; nothing of it is written. */
export function createPastParameters(
  known: KnownAt,
  asking: RequesterParts,
): { readonly actions: ParameterActions; readonly takeEvent: (event: StreamEvent) => void } {
  const values = createParameters();
  known.onKnown((then) => {
    forget(values);
    if (then?.parameters != null) {
      take(values, Object.fromEntries(then.parameters.map(({ name, ...held }) => [name, held])));
    }
  });
  return {
    actions: { ...createParameterActions(values, asking), refresh: known.read },
    takeEvent: (event) => {
      // Of a flight of the past only the 17 are known at every moment.
      if (event.event !== "own_gains") {
        takeParameterEvent(values, event, asking.wall_ms());
      }
    },
  };
}
