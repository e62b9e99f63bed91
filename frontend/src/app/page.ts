import { ABOUT, createAbout } from "../features/about/aboutRequests";
import { createAhrs3d } from "../features/ahrs/ahrsRequests";
import { AHRS } from "../features/ahrs/alignment";
import type { Sounder, Speaker } from "../features/alarms/alarmLog";
import { ALARM_LOG, takeAlarmEvent } from "../features/alarms/alarmLog";
import { createAlarmLog } from "../features/alarms/alarmRequests";
import {
  createSourceReturn,
  NOTHING_LEFT_OFF,
  SOURCE_RETURN,
  takeHeartbeats,
} from "../features/controls/sourceReturn";
import { createEmulation, EMULATION } from "../features/emulation/emulationRequests";
import { createGamepadInput, type GamepadReader } from "../features/gamepad/gamepadInput";
import { GAMEPADS } from "../features/gamepad/gamepadList";
import { MAP_LAYERS } from "../features/map/layers/layerList";
import { createMapLayerActions } from "../features/map/layers/layerRequests";
import { createMapSelection, MAP_SELECTION } from "../features/map/mapSelection";
import { createTrackEdits, TRACK_EDITS } from "../features/map/trackEdits";
import { TRACK_LOG } from "../features/map/trackLog";
import { createTrackLog } from "../features/map/trackRequests";
import { createInspector, INSPECTOR } from "../features/messages/inspectorRequests";
import { createParameterActions, takeParameterEvent } from "../features/parameters/parameterRequests";
import { createParameters, forget, PARAMETER_REQUESTS } from "../features/parameters/parameterValues";
import { SERVO_SLIDERS } from "../features/servos/servoPositions";
import { createServoSliders } from "../features/servos/servoSliders";
import { BOARD_CONSOLE } from "../features/setup/consoleLog";
import { createBoardConsole } from "../features/setup/consoleRequests";
import type { AnimationFrames } from "../lib/animationFrames";
import type { Timers } from "../lib/timers";
import { createPlanActions, takePlanEvent, takePlanStatus } from "../missions/missionRequests";
import { createPlans, MISSIONS } from "../missions/planDrafts";
import { BOARD_RESTARTED } from "../protocol/boardRestart";
import type { StreamEvent, StreamMessage } from "../protocol/envelope";
import type { Status } from "../protocol/status";
import { ACTIONS, createActions } from "../requests/actions";
import { createCommands } from "../store/commands";
import { createConnection } from "../store/connection";
import { DamageRate } from "../store/damage";
import type { Page } from "../store/hooks";
import { createMessages, type Message, say } from "../store/messages";
import { Parts } from "../store/parts";
import { Pump } from "../store/pump";
import { StreamRates } from "../store/rates";
import { type BrowserStorage, createSettings } from "../store/settings";
import { TelemetryStore } from "../store/telemetry";
import { Rest } from "../transport/rest";
import { StreamSocket, type Wire, type WireListener } from "../transport/socket";
import { eventMessage, linkMessages } from "./announcements";

/** What the page needs from outside: given by a browser's window, or by a test. */
export interface World {
  readonly timers: Timers;
  readonly wall_ms: () => number;
  readonly dial: (client: string | null, listener: WireListener) => Wire;
  readonly fetch: (path: string, init: RequestInit) => Promise<Response>;
  readonly animationFrames: AnimationFrames;
  /** `storage` outlives the browser; `tabStorage` lasts until this browser tab is closed. */
  readonly storage: BrowserStorage | null;
  readonly tabStorage: BrowserStorage | null;
  readonly sounder: Sounder;
  readonly speaker: Speaker;
  readonly gamepads: GamepadReader;
  /** Saves a file on the user's computer. */
  readonly saveFile: (name: string, content: Blob) => void;
  /** Reports an exception in the page's own code: to the browser's console. */
  readonly report: (error: unknown) => void;
}

const CLIENT_KEY = "epf-gcs.client";

/** Makes the page's parts and connects them. Only here is a message handed from the transport to the stores. */
export function createPage(world: World): {
  readonly page: Page;
  readonly start: () => void;
  readonly stop: () => void;
} {
  const telemetry = new TelemetryStore();
  const connection = createConnection();
  const commands = createCommands();
  const messages = createMessages();
  const settings = createSettings(world.storage);
  const parameterValues = createParameters();
  const plans = createPlans(world.storage);
  const sourceReturn = createSourceReturn();
  const damage = new DamageRate();
  const rates = new StreamRates();
  const now_ms = world.timers.now_ms;
  const pump = new Pump(world.animationFrames, () => telemetry.revision, now_ms(), fail);
  const client = (): string | null => connection.getState().client;
  const tell = (message: Message): void => say(messages, message, world.wall_ms());

  /** Part of the page failed and the rest goes on: what that part shows may be old. */
  function fail(error: unknown): void {
    tell({ level: "error", key: "said.pageFailed", params: {} });
    world.report(error);
  }

  function takeStatus(status: Status, at_ms: number): void {
    telemetry.heard(at_ms);
    servos.takeStatus(status);
    linkMessages(connection.getState().status, status).forEach(tell);
    const board = connection.getState().status?.board ?? null;
    takePlanStatus(plans, board, status.board);
    if (board !== null && board.url !== status.board.url) {
      sourceReturn.setState(NOTHING_LEFT_OFF);
    }
    telemetry.setStaleAfter(
      Object.entries(status.topics).map(([topic, { stale_after_s }]) => [topic, stale_after_s]),
    );
    const counts = Object.fromEntries(
      Object.entries(status.topics).map(([topic, { count }]) => [topic, count]),
    );
    connection.setState({
      status,
      damagedLastSecond: damage.observe(status.board.frames_damaged, at_ms),
      rates_hz: rates.observe(status.server_time_s, counts),
    });
  }

  function takeEvent(message: StreamEvent): void {
    servos.takeEvent(message);
    takeConsole(message);
    takeParameterEvent(parameterValues, message, world.wall_ms());
    takePlanEvent(plans, message, client());
    takeMapEvent(message);
    takeTrackEvent(message);
    gamepads.takeEvent(message);
    takeAlarmEvent(alarmLog.store, message);
    if (message.event === BOARD_RESTARTED) {
      // Its restart is reported on its own, with all that it switched off.
      sourceReturn.setState(NOTHING_LEFT_OFF);
    }
    const said = eventMessage(message, client());
    if (said !== null) {
      tell(said);
    }
  }

  function take(message: StreamMessage, at_ms: number): void {
    switch (message.type) {
      case "batch":
        telemetry.apply(message.t_s, message.samples, at_ms);
        takeHeartbeats(sourceReturn, message.samples);
        if (message.rows !== null) {
          telemetry.applyRows(message.rows);
        }
        return;
      case "status":
        takeStatus(message.data, at_ms);
        return;
      case "event":
        telemetry.heard(at_ms);
        takeEvent(message);
        return;
      case "hello":
        telemetry.greet(message.server_time_s, at_ms);
        connection.setState({ client: message.client });
        remember(world.tabStorage, message.client);
        takeStatus(message.status, at_ms);
    }
  }

  const socket = new StreamSocket({
    dial: (listener) => world.dial(client() ?? remembered(world.tabStorage), listener),
    timers: world.timers,
    onMessage: take,
    onState: ({ kind }) => {
      if (kind !== "open") {
        telemetry.silence();
        forget(parameterValues);
      }
      connection.setState({ phase: kind });
    },
    onMalformed: () => {
      connection.setState(({ malformed }) => ({ malformed: malformed + 1 }));
      tell({ level: "error", key: "said.malformed", params: {} });
    },
  });
  const rest = new Rest({ fetch: world.fetch, client });
  const asking = { rest, commands, messages, now_ms, wall_ms: world.wall_ms };
  const servos = createServoSliders({ rest, timers: world.timers, client, tell });
  const { boardConsole, takeEvent: takeConsole } = createBoardConsole({ rest, wall_ms: world.wall_ms });
  const actions = createActions({ ...asking, client });
  const gamepads = createGamepadInput({
    reader: world.gamepads,
    timers: world.timers,
    connection,
    settings,
    setStick: actions.setStick,
    send: (text) => socket.offer(text),
    tell,
  });
  const alarmLog = createAlarmLog({
    ...asking,
    connection,
    telemetry,
    settings,
    timers: world.timers,
    sounder: world.sounder,
    speaker: world.speaker,
  });
  const { mapLayers, takeMapEvent } = createMapLayerActions({ ...asking, timers: world.timers });
  const { trackLog, takeTrackEvent } = createTrackLog({ rest, timers: world.timers, report: fail });
  const parts = new Parts()
    .with(ACTIONS, actions)
    .with(ALARM_LOG, alarmLog)
    .with(PARAMETER_REQUESTS, createParameterActions(parameterValues, asking))
    .with(MISSIONS, createPlanActions(plans, world.saveFile, asking))
    .with(AHRS, createAhrs3d(asking))
    .with(SOURCE_RETURN, sourceReturn)
    .with(MAP_SELECTION, createMapSelection())
    .with(MAP_LAYERS, mapLayers)
    .with(TRACK_LOG, trackLog)
    .with(TRACK_EDITS, createTrackEdits(asking))
    .with(SERVO_SLIDERS, servos.sliders)
    .with(GAMEPADS, gamepads.gamepads)
    .with(BOARD_CONSOLE, boardConsole)
    .with(INSPECTOR, createInspector(rest))
    .with(EMULATION, createEmulation(asking))
    .with(ABOUT, createAbout(asking));
  return {
    page: {
      telemetry,
      pump,
      connection,
      commands,
      messages,
      settings,
      parts,
      saveFile: world.saveFile,
    },
    start: () => {
      socket.start();
      gamepads.start();
    },
    stop: () => {
      gamepads.stop();
      socket.stop();
    },
  };
}

function remembered(storage: BrowserStorage | null): string | null {
  try {
    return storage?.getItem(CLIENT_KEY) ?? null;
  } catch {
    return null;
  }
}

/**
 * Keep the name of this tab's connection, so that the gateway knows the same client after a reload, which then keeps
 * control.
 */
function remember(storage: BrowserStorage | null, client: string): void {
  try {
    storage?.setItem(CLIENT_KEY, client);
  } catch {
    // Storage is forbidden: after a reload the gateway sees a new client.
  }
}
