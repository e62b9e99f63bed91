import type { Timers } from "../lib/timers";
import type { Status } from "../protocol/contract";
import type { StreamEvent } from "../protocol/envelope";
import type { RequesterParts } from "../requests/asking";
import { refusedInPast } from "../requests/pastGuard";
import { type AdmissionStore, createAdmission } from "../store/admission";
import { createCommands } from "../store/commands";
import { createMessages, type Message } from "../store/messages";
import type { Parts } from "../store/parts";
import { createSettings, type SettingsStore } from "../store/settings";
import { Rest } from "../transport/rest";
import { createVehicle, type Vehicle } from "./vehicle";
import type { World } from "./world";

/** What every group of features is made of. */
export interface Core extends RequesterParts {
  readonly world: World;
  readonly timers: Timers;
  readonly vehicle: Vehicle;
  readonly admission: AdmissionStore;
  readonly settings: SettingsStore;
  readonly rest: Rest;
  /** The name that the gateway gave this page; null while not connected. */
  readonly client: () => string | null;
  /** Say what happened by itself. */
  readonly tell: (message: Message) => void;
  /** Part of the page failed and the rest goes on: what that part shows may be old. */
  readonly fail: (error: unknown) => void;
  readonly malformed: () => void;
}

/** A group of features, as the page connects it. */
export interface Group {
  readonly addTo: (parts: Parts) => Parts;
  readonly takeEvent?: (event: StreamEvent) => void;
  /** Called before the vehicle takes the status: what changed is found by comparing. */
  readonly takeStatus?: (before: Status | null, status: Status) => void;
}

/** `isPast`: a flight of the past is shown, in which nothing may be commanded. */
export function createCore(world: World, isPast: () => boolean): Core {
  const vehicle = createVehicle();
  const { connection } = vehicle;
  const messages = createMessages(world, world.tabStorage);
  const tell = messages.announce;
  const client = (): string | null => connection.getState().client;

  function fail(error: unknown): void {
    tell({ level: "error", key: "said.pageFailed", params: {} });
    world.report(error);
  }

  const timers: Timers = { ...world.timers, report: fail };
  return {
    world,
    timers,
    vehicle,
    admission: createAdmission(),
    settings: createSettings(world.storage, world.languages),
    commands: createCommands(),
    messages,
    now_ms: timers.now_ms,
    wall_ms: world.wall_ms,
    rest: new Rest({
      fetch: world.fetch,
      upload: world.upload,
      client,
      refuse: (method, path) => (isPast() ? refusedInPast(method, path) : null),
    }),
    client,
    tell,
    fail,
    malformed: () => {
      connection.setState((before) => ({ malformed: before.malformed + 1 }));
      tell({ level: "error", key: "said.malformed", params: {} });
    },
  };
}
