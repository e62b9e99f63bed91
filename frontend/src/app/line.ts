import type { Status } from "../protocol/contract";
import type { Batch, StreamEvent, StreamMessage } from "../protocol/envelope";
import type { LinePhase } from "../store/connection";
import { StreamSocket } from "../transport/socket";
import { eventMessage } from "./announcements";
import { rememberClient, rememberedClient } from "./clientMemory";
import type { Core, Group } from "./core";

interface Listeners {
  /** In the order in which they hear. */
  readonly groups: () => readonly Group[];
  readonly onHello: () => void;
  readonly onSamples: (samples: Batch["samples"]) => void;
  readonly onPhase: (phase: LinePhase) => void;
}

/** The stream of the present. Only here is a message handed from the transport to the stores. */
export function createLine(core: Core, { groups, onHello, onSamples, onPhase }: Listeners): StreamSocket {
  const { vehicle, world, client, tell } = core;

  function takeStatus(status: Status): void {
    const before = vehicle.connection.getState().status;
    for (const group of groups()) group.takeStatus?.(before, status);
  }

  function takeEvent(message: StreamEvent): void {
    for (const group of groups()) group.takeEvent?.(message);
    const said = eventMessage(message, client());
    if (said !== null) tell(said);
  }

  function take(message: StreamMessage, at_ms: number): void {
    if (message.type === "status") {
      takeStatus(message.data);
    } else if (message.type === "hello") {
      takeStatus(message.status);
      rememberClient(world.tabStorage, message.client);
      onHello();
    }
    vehicle.take(message, at_ms);
    if (message.type === "batch") {
      onSamples(message.samples);
    } else if (message.type === "event") {
      takeEvent(message);
    }
  }

  return new StreamSocket({
    dial: (listener) => world.dial(client() ?? rememberedClient(world.tabStorage), listener),
    timers: core.timers,
    wall_ms: core.wall_ms,
    onMessage: take,
    onState: ({ kind }) => onPhase(kind),
    onMalformed: core.malformed,
    report: core.fail,
  });
}
