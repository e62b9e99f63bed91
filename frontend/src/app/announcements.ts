import type { Status } from "../protocol/contract";
import type { StreamEvent } from "../protocol/envelope";
import { resultMessage } from "../requests/actions";
import { failureMessage, type Message } from "../store/messages";

/** Announce link changes, except while a link is opening. */
export function linkMessages(before: Status | null, status: Status): readonly Message[] {
  return (["board", "simulator"] as const).flatMap((end): readonly Message[] => {
    const { state } = status[end];
    if (before === null || before[end].state === state || state === "opening") {
      return [];
    }
    const level = state === "lost" ? "warning" : "info";
    return [{ level, key: "said.link", params: { what: `@end.${end}`, state: `@link.${state}` } }];
  });
}

/** The message for an event: an error of the gateway, a jump of the simulator's aircraft, a fault in it, or the outcome of another browser's command. */
export function eventMessage({ event, data }: StreamEvent, client: string | null): Message | null {
  if (event === "error") {
    return failureMessage(data, "warning");
  }
  if (event === "simulator_jumped") {
    return { level: "info", key: "said.jumped", params: { distance_m: data.distance_m } };
  }
  if (event === "fault") {
    const key = data.state === "begun" ? "said.faultBegun" : "said.faultEnded";
    const params = { place: `@faultPlace.${data.place}`, kind: `@faultKind.${data.kind}` };
    return { level: data.state === "begun" ? "warning" : "info", key, params };
  }
  if (
    event === "command" &&
    data.client !== client &&
    data.state !== "pending" &&
    // A servo's slider sends twenty commands a second: announce only failures.
    !(data.name === "servo_out" && data.state !== "rejected" && data.state !== "timed_out")
  ) {
    const { name, state, by, ms, reason } = data;
    return resultMessage(`@command.${name}`, { state, by, ms: ms ?? 0, reason });
  }
  return null;
}
