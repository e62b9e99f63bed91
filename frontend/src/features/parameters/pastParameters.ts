import type { StreamEvent } from "../../protocol/envelope";
import type { RequesterParts } from "../../requests/asking";
import type { KnownAt } from "../../requests/knownAt";
import { createParameterActions, takeParameterEvent } from "./parameterRequests";
import { createParameters, forget, type ParameterActions, take, takeOwn } from "./parameterValues";

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
    if (then?.own != null) {
      takeOwn(values, then.own);
    }
  });
  return {
    actions: { ...createParameterActions(values, asking), refresh: known.read },
    takeEvent: (event) => takeParameterEvent(values, event, asking.wall_ms()),
  };
}
