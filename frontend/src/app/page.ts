import type { Page } from "../store/hooks";
import { Parts } from "../store/parts";
import { Pump } from "../store/pump";
import { rememberClient } from "./clientMemory";
import { createCockpit } from "./cockpit";
import { type Core, createCore, type Group } from "./core";
import { createDoor } from "./door";
import { createHistory } from "./history";
import { createLine } from "./line";
import { createMapParts } from "./mapParts";
import { createPasts, SHOWN } from "./past";
import type { World } from "./world";

/** Makes the page's groups and connects them. */
export function createPage(world: World): {
  readonly page: Page;
  readonly start: () => void;
  readonly stop: () => void;
} {
  const core = createCore(world, () => history.playback.store.getState().flight !== null);
  const { vehicle } = core;
  const line = createLine(core, {
    groups: () => groups,
    onHello: () => {
      door.review();
      world.versions.look();
    },
    onSamples: (samples) => cockpit.takeSamples(samples),
    onPhase: (phase) => {
      if (phase !== "open") cockpit.lost();
      vehicle.become(phase);
      if (phase === "waiting") door.review();
    },
  });
  const door = createDoor(core, () => line.start(), shutOut);
  const cockpit = createCockpit(core, (text) => line.offer(text));
  const map = createMapParts(core, core.timers, core.fail);
  const history = createHistory(core, cockpit, (place, listener) => pasts.open(place, listener));
  const groups: readonly Group[] = [cockpit, map, history, door];
  const page = pageOf(core, groups, () => pasts.revision());
  const pasts = createPasts(core, page, history.playback);
  page.parts.with(SHOWN, pasts.shown);

  /** Not admitted, or no longer: the stream ends, and whoever enters next gets a connection with a name of its own. */
  function shutOut(): void {
    history.playback.now();
    line.stop();
    vehicle.connection.setState({ client: null, status: null });
    vehicle.become("connecting");
    cockpit.shutOut();
    rememberClient(world.tabStorage, null);
  }

  return {
    page,
    start: () => {
      door.start();
      cockpit.start();
      history.start();
    },
    stop: () => {
      history.playback.now();
      cockpit.stop();
      line.stop();
    },
  };
}

/** The present, as the tabs see it. `revision` changes whenever something new is known of a flight of the past. */
function pageOf(core: Core, groups: readonly Group[], revision: () => number): Page {
  const { world, vehicle, timers, fail } = core;
  const { telemetry, connection } = vehicle;
  const pump = new Pump(world.animationFrames, () => telemetry.revision + revision(), timers.now_ms(), fail);
  return {
    telemetry,
    pump,
    connection,
    admission: core.admission,
    commands: core.commands,
    messages: core.messages,
    settings: core.settings,
    parts: groups.reduce((parts, group) => group.addTo(parts), new Parts()),
    past: null,
    key: 0,
    saveFile: world.saveFile,
  };
}
