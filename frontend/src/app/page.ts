import { isNumber, isObject, isText, nullable, oneOf, shape } from "../lib/check";
import type { StreamEvent, StreamMessage } from "../protocol/envelope";
import type { Status } from "../protocol/status";
import type { Sounder, Speaker } from "../store/alarmBook";
import { BOARD_RESTARTED } from "../store/alarms";
import { createCommands } from "../store/commands";
import { createConnection } from "../store/connection";
import { DamageRate } from "../store/damage";
import type { Page } from "../store/hooks";
import { createMapSelection } from "../store/mapSelection";
import { createMessages, failureMessage, type Message, say } from "../store/messages";
import { createParameters, forget } from "../store/parameters";
import { createPlans } from "../store/plans";
import { type FrameSource, Pump } from "../store/pump";
import { StreamRates } from "../store/rates";
import { createSettings, type Shelf } from "../store/settings";
import { createSourceReturn, NOTHING_LEFT_OFF, takeHeartbeats } from "../store/sourceReturn";
import { TelemetryStore } from "../store/telemetry";
import { Rest } from "../transport/rest";
import { StreamSocket, type Timers, type Wire, type WireListener } from "../transport/socket";
import { createActions, resultMessage } from "./actions";
import { createAhrs3d } from "./ahrs3dActions";
import { createAlarmBook, takeAlarmEvent } from "./alarmBook";
import { createBoardConsole } from "./boardConsole";
import { createFrameActions } from "./frameActions";
import { createGamepadDesk, type GamepadReader } from "./gamepadDesk";
import { createInspector } from "./inspector";
import { createMapLayerActions } from "./mapLayerActions";
import { createParameterActions, takeParameterEvent } from "./parameterActions";
import { createPlanActions, takePlanEvent, takePlanStatus } from "./planActions";
import { createServoDesk } from "./servoDesk";
import { createTrackBook } from "./trackActions";

/** What the page needs of the world around it: a browser's window, or a test. */
export interface World {
  readonly timers: Timers;
  readonly wall_ms: () => number;
  readonly dial: (client: string | null, listener: WireListener) => Wire;
  readonly fetch: (path: string, init: RequestInit) => Promise<Response>;
  readonly requestFrame: (callback: (now_ms: number) => void) => number;
  readonly cancelFrame: (handle: number) => void;
  readonly measureFrame?: FrameSource["measure"];
  /** Remembered for ever, and for as long as this browser tab lives. */
  readonly shelf: Shelf | null;
  readonly tabShelf: Shelf | null;
  readonly sounder: Sounder;
  readonly speaker: Speaker;
  readonly gamepads: GamepadReader;
  /** Gives the person a file to keep. */
  readonly saveFile: (name: string, content: Blob) => void;
  /** Tells whoever looks for the cause of an exception in the page's own code: a browser's console. */
  readonly report: (error: unknown) => void;
}

const CLIENT_KEY = "epf-gcs.client";

const isCommandEvent = shape({
  name: isText,
  client: nullable(isText),
  state: oneOf("pending", "confirmed", "rejected", "timed_out", "sent"),
  by: isText,
  ms: nullable(isNumber),
  reason: nullable(isText),
});
const isErrorEvent = shape({ code: isText, detail: isText, params: isObject });

/** Puts stores, transport and actions together: here alone each message goes from the one to the others. */
export function createPage(world: World): {
  readonly page: Page;
  readonly start: () => void;
  readonly stop: () => void;
} {
  const telemetry = new TelemetryStore();
  const connection = createConnection();
  const commands = createCommands();
  const messages = createMessages();
  const settings = createSettings(world.shelf);
  const book = createParameters();
  const plans = createPlans(world.shelf);
  const sourceReturn = createSourceReturn();
  const damage = new DamageRate();
  const rates = new StreamRates();
  const now_ms = world.timers.now_ms;
  const pump = new Pump(
    {
      request: world.requestFrame,
      cancel: world.cancelFrame,
      ...(world.measureFrame && { measure: world.measureFrame }),
    },
    () => telemetry.revision,
    now_ms(),
    fail,
  );
  const client = (): string | null => connection.getState().client;
  const tell = (message: Message): void => say(messages, message, world.wall_ms());

  /** Part of the page failed and the rest goes on: what that part shows may be old. */
  function fail(error: unknown): void {
    tell({ level: "error", key: "said.pageFailed", params: {} });
    world.report(error);
  }

  /** A line that came or went is told; on its way from the one to the other it is not. */
  function tellLinks(before: Status | null, status: Status): void {
    for (const end of ["board", "simulator"] as const) {
      const { state } = status[end];
      if (before !== null && before[end].state !== state && state !== "opening") {
        const level = state === "lost" ? "warning" : "info";
        tell({ level, key: "said.link", params: { what: `@end.${end}`, state: `@link.${state}` } });
      }
    }
  }

  function takeStatus(status: Status, at_ms: number): void {
    telemetry.heard(at_ms);
    servos.takeStatus(status);
    tellLinks(connection.getState().status, status);
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
    const { event, data } = message;
    servos.takeEvent(message);
    takeConsole(message);
    takeParameterEvent(book, message, world.wall_ms());
    takePlanEvent(plans, message, client());
    takeMapEvent(message);
    takeTrackEvent(message);
    gamepads.takeEvent(message);
    takeAlarmEvent(alarmBook, message);
    if (event === BOARD_RESTARTED) {
      // Its restart is told by itself, with all that it switched off.
      sourceReturn.setState(NOTHING_LEFT_OFF);
    } else if (event === "error" && isErrorEvent(data)) {
      tell(failureMessage(data, "warning"));
    } else if (
      event === "command" &&
      isCommandEvent(data) &&
      data.client !== client() &&
      data.state !== "pending" &&
      !(data.name === "servo_out" && data.state !== "rejected" && data.state !== "timed_out")
    ) {
      const { name, state, by, ms, reason } = data;
      tell(resultMessage(`@command.${name}`, { state, by, ms: ms ?? 0, reason }));
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
        remember(world.tabShelf, message.client);
        takeStatus(message.status, at_ms);
    }
  }

  const socket = new StreamSocket({
    dial: (listener) => world.dial(client() ?? remembered(world.tabShelf), listener),
    timers: world.timers,
    onMessage: take,
    onState: ({ kind }) => {
      if (kind !== "open") {
        telemetry.silence();
        forget(book);
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
  const servos = createServoDesk({ rest, timers: world.timers, client, tell });
  const { boardConsole, takeEvent: takeConsole } = createBoardConsole({ rest, wall_ms: world.wall_ms });
  const actions = createActions({ ...asking, client });
  const frame = createFrameActions(asking);
  const gamepads = createGamepadDesk({
    reader: world.gamepads,
    timers: world.timers,
    connection,
    settings,
    setStick: actions.setStick,
    send: (text) => socket.offer(text),
    tell,
  });
  const alarmBook = createAlarmBook({
    ...asking,
    connection,
    telemetry,
    settings,
    timers: world.timers,
    sounder: world.sounder,
    speaker: world.speaker,
  });
  const parameters = createParameterActions(book, asking);
  const ahrs3d = createAhrs3d(asking);
  const missions = createPlanActions(plans, world.saveFile, asking);
  const { mapLayers, takeMapEvent } = createMapLayerActions({ ...asking, timers: world.timers });
  const { trackBook, takeTrackEvent } = createTrackBook({
    rest,
    timers: world.timers,
    report: fail,
  });
  const stores = { telemetry, pump, connection, commands, messages, settings };
  return {
    page: {
      ...stores,
      actions,
      frame,
      alarmBook,
      parameters,
      missions,
      sourceReturn,
      ahrs3d,
      mapSelection: createMapSelection(),
      mapLayers,
      servos: servos.desk,
      gamepads: gamepads.desk,
      boardConsole,
      trackBook,
      inspector: createInspector(rest),
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

function remembered(shelf: Shelf | null): string | null {
  try {
    return shelf?.getItem(CLIENT_KEY) ?? null;
  } catch {
    return null;
  }
}

/** The name of this tab's connection, so that a reload is the same client and keeps control. */
function remember(shelf: Shelf | null, client: string): void {
  try {
    shelf?.setItem(CLIENT_KEY, client);
  } catch {
    // Without a memory a reload is a new client.
  }
}
