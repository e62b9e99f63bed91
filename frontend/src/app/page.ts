import { ABOUT, createAbout } from "../features/about/aboutRequests";
import { ACCESS_ADMIN, createAccessAdmin } from "../features/access/accessAdmin";
import { controlMessage } from "../features/access/controlEvents";
import { CONTROL_PAGES, createControlPages } from "../features/access/controlPages";
import { createEntry, ENTRY } from "../features/access/entry";
import { takeAddressedKey } from "../features/access/keyAddress";
import { createNewVersion, NEW_VERSION } from "../features/access/newVersion";
import { createAhrs3d } from "../features/ahrs/ahrsRequests";
import { AHRS } from "../features/ahrs/alignment";
import type { Sounder, Speaker } from "../features/alarms/alarmLog";
import { ALARM_LOG, forgetOwnAlarm, takeAlarmEvent } from "../features/alarms/alarmLog";
import { createAlarmLog } from "../features/alarms/alarmRequests";
import { CHECKLIST } from "../features/checklist/checklist";
import {
  createSourceReturn,
  NOTHING_LEFT_OFF,
  SOURCE_RETURN,
  takeHeartbeats,
} from "../features/controls/sourceReturn";
import { createEmulation, EMULATION } from "../features/emulation/emulationRequests";
import { FLIGHT_COMPARISON } from "../features/flights/flightComparison";
import { FLIGHTS } from "../features/flights/flightLibrary";
import { createFlights } from "../features/flights/flightRequests";
import { createGamepadInput } from "../features/gamepad/gamepadInput";
import type { GamepadReader } from "../features/gamepad/gamepadList";
import { GAMEPADS } from "../features/gamepad/gamepadList";
import { TOUCH_STICK } from "../features/gamepad/touchStick";
import { FLIGHT_LOG } from "../features/log/flightLog";
import { createInspector, INSPECTOR } from "../features/messages/inspectorRequests";
import { createParameterActions, takeParameterEvent } from "../features/parameters/parameterRequests";
import { createParameters, forget, PARAMETER_REQUESTS } from "../features/parameters/parameterValues";
import { type AddressLine, createFlightAddress, type PlaceInTime } from "../features/playback/flightAddress";
import { createPlayback, PLAYBACK, type Playback } from "../features/playback/playbackRequests";
import { createPlots, PLOTS } from "../features/plots/plots";
import { addressedReport, createReports, keepReport, REPORTS } from "../features/report/reportRequests";
import { SERVO_SLIDERS } from "../features/servos/servoPositions";
import { createServoSliders } from "../features/servos/servoSliders";
import { BOARD_CONSOLE } from "../features/setup/consoleLog";
import { createBoardConsole } from "../features/setup/consoleRequests";
import type { AnimationFrames, Timers } from "../lib/timers";
import { createPlanActions, takePlanEvent, takePlanStatus } from "../missions/missionRequests";
import { createPlans, MISSIONS } from "../missions/planDrafts";
import { createSelection, SELECTION } from "../missions/selection";
import type { Status } from "../protocol/contract";
import type { StreamEvent, StreamMessage } from "../protocol/envelope";
import { ACTIONS, createActions } from "../requests/actions";
import { refusedInPast } from "../requests/pastGuard";
import { createAdmission } from "../store/admission";
import { createCommands } from "../store/commands";
import type { Page } from "../store/hooks";
import { createMessages } from "../store/messages";
import { Parts } from "../store/parts";
import { Pump } from "../store/pump";
import { type BrowserStorage, choose, createSettings } from "../store/settings";
import { Rest, type UploadInit } from "../transport/rest";
import { StreamSocket, type Wire, type WireListener } from "../transport/socket";
import { eventMessage, linkMessages } from "./announcements";
import { rememberClient, rememberedClient } from "./clientMemory";
import { createFlightBook } from "./flightBook";
import { createMapParts } from "./mapParts";
import type { PageVersions } from "./pageVersion";
import { createPasts, SHOWN } from "./past";
import { plotTimeline } from "./plotTimeline";
import { twoFlights } from "./twoFlights";
import { createVehicle } from "./vehicle";
import { openAddressedTab } from "./views/views";

/** What the page needs from outside: given by a browser's window, or by a test. */
export interface World {
  readonly timers: Timers;
  readonly wall_ms: () => number;
  readonly dial: (client: string | null, listener: WireListener) => Wire;
  /** Connects to the stream of a flight of the past, from a moment on. */
  readonly dialFlight: (place: PlaceInTime, listener: WireListener) => Wire;
  readonly fetch: (path: string, init: RequestInit) => Promise<Response>;
  readonly upload: (path: string, init: UploadInit) => Promise<Response>;
  readonly animationFrames: AnimationFrames;
  /** `storage` outlives the browser; `tabStorage` lasts until this browser tab is closed. */
  readonly storage: BrowserStorage | null;
  readonly tabStorage: BrowserStorage | null;
  readonly sounder: Sounder;
  readonly speaker: Speaker;
  readonly gamepads: GamepadReader;
  readonly address: AddressLine;
  readonly versions: PageVersions;
  /** Saves a file on the user's computer. */
  readonly saveFile: (name: string, content: Blob) => void;
  /** Reports an exception in the page's own code: to the browser's console. */
  readonly report: (error: unknown) => void;
}

/** Makes the page's parts and connects them. Only here is a message handed from the transport to the stores. */
export function createPage(world: World): {
  readonly page: Page;
  readonly start: () => void;
  readonly stop: () => void;
} {
  const vehicle = createVehicle();
  const admission = createAdmission();
  const addressed = takeAddressedKey(world.address);
  const { telemetry, connection } = vehicle;
  const commands = createCommands();
  const messages = createMessages(world, world.tabStorage);
  const settings = createSettings(world.storage);
  const parameterValues = createParameters();
  const plans = createPlans(world.storage);
  const sourceReturn = createSourceReturn();
  const timers: Timers = { ...world.timers, report: fail };
  const { now_ms } = timers;
  const pump = new Pump(world.animationFrames, () => telemetry.revision + pasts.revision(), now_ms(), fail);
  const client = (): string | null => connection.getState().client;
  const tell = messages.announce;

  /** Part of the page failed and the rest goes on: what that part shows may be old. */
  function fail(error: unknown): void {
    tell({ level: "error", key: "said.pageFailed", params: {} });
    world.report(error);
  }

  function malformed(): void {
    connection.setState((before) => ({ malformed: before.malformed + 1 }));
    tell({ level: "error", key: "said.malformed", params: {} });
  }

  /** Not admitted, or no longer: the stream ends, and whoever enters next gets a connection with a name of its own. */
  function shutOut(): void {
    playback.now();
    socket.stop();
    connection.setState({ client: null, status: null });
    vehicle.become("connecting");
    forgetOwnAlarm(alarmLog.store);
    rememberClient(world.tabStorage, null);
  }

  /** Called before the vehicle takes the status: what changed is found by comparing. */
  function followStatus(status: Status): void {
    const before = connection.getState().status;
    servos.takeStatus(status);
    linkMessages(before, status).forEach(tell);
    takePlanStatus(plans, before?.board ?? null, status.board);
    if (before !== null && before.board.url !== status.board.url) {
      sourceReturn.setState(NOTHING_LEFT_OFF);
    }
  }

  function takeEvent(message: StreamEvent): void {
    servos.takeEvent(message);
    takeConsole(message);
    takeParameterEvent(parameterValues, message, world.wall_ms());
    takePlanEvent(plans, message, client());
    map.takeEvent(message);
    takeFlightEvent(message);
    book.takeEvent(message);
    gamepads.takeEvent(message);
    takeAlarmEvent(alarmLog.store, message);
    if (message.event === "access") {
      review();
    }
    if (message.event === "board_restarted") {
      // Its restart is reported on its own, with all that it switched off.
      sourceReturn.setState(NOTHING_LEFT_OFF);
    }
    const control = controlMessage(message, client());
    if (control !== null) {
      (control.isAnswer ? messages.say : tell)(control.message);
    }
    const said = eventMessage(message, client());
    if (said !== null) {
      tell(said);
    }
  }

  function take(message: StreamMessage, at_ms: number): void {
    if (message.type === "status") {
      followStatus(message.data);
    } else if (message.type === "hello") {
      followStatus(message.status);
      rememberClient(world.tabStorage, message.client);
      review();
      world.versions.look();
    }
    vehicle.take(message, at_ms);
    if (message.type === "batch") {
      takeHeartbeats(sourceReturn, message.samples);
    } else if (message.type === "event") {
      takeEvent(message);
    }
  }

  const socket = new StreamSocket({
    dial: (listener) => world.dial(client() ?? rememberedClient(world.tabStorage), listener),
    timers,
    wall_ms: world.wall_ms,
    onMessage: take,
    onState: ({ kind }) => {
      if (kind !== "open") {
        forget(parameterValues);
      }
      vehicle.become(kind);
      if (kind === "waiting") {
        review();
      }
    },
    onMalformed: malformed,
    report: fail,
  });
  const rest = new Rest({
    fetch: world.fetch,
    upload: world.upload,
    client,
    refuse: (method, path) =>
      playback.store.getState().flight === null ? null : refusedInPast(method, path),
  });
  const asking = { rest, commands, messages, now_ms, wall_ms: world.wall_ms };
  const { entry, begin, review } = createEntry({
    rest,
    timers,
    admission,
    addressed,
    isEncrypted: world.address.read().startsWith("https:"),
    start: () => socket.start(),
    stop: shutOut,
  });
  const servos = createServoSliders({ rest, timers, client, tell });
  const { boardConsole, takeEvent: takeConsole } = createBoardConsole({ rest, wall_ms: world.wall_ms });
  const actions = createActions({ ...asking, client });
  const gamepads = createGamepadInput({
    reader: world.gamepads,
    timers,
    connection,
    settings,
    setStick: actions.setStick,
    send: (text) => socket.offer(text),
    tell,
    report: fail,
  });
  const alarmLog = createAlarmLog({
    ...asking,
    connection,
    telemetry,
    settings,
    timers,
    sounder: world.sounder,
    speaker: world.speaker,
  });
  const map = createMapParts(asking, timers, fail);
  const address = createFlightAddress(world.address, timers);
  const playback: Playback = createPlayback({
    rest,
    timers,
    address,
    isRecording: () => connection.getState().status?.recording.active === true,
    open: (place, listener) => pasts.open(place, listener),
  });
  const newVersion = createNewVersion();
  const reports = createReports(rest, (flight, compare) => keepReport(world.address, flight, compare));
  const { flights, takeFlightEvent } = createFlights({
    ...asking,
    timers,
    connection,
    openFlight: playback.openFlight,
    play: playback.play,
    onGone: (flight) => playback.store.getState().flight === flight && playback.now(),
    openReport: (flight) => reports.open(flight),
  });
  const book = createFlightBook({
    rest,
    timers,
    tabStorage: world.tabStorage,
    seen: { ...vehicle, plans, gains: parameterValues, alarms: alarmLog.store, now_ms },
  });
  const plots = createPlots({ rest, timers, timeline: plotTimeline(playback) });
  const comparison = twoFlights({ reports, plots, settings });
  const parts = map
    .addTo(new Parts())
    .with(PLAYBACK, playback)
    .with(ENTRY, entry)
    .with(NEW_VERSION, newVersion)
    .with(ACCESS_ADMIN, createAccessAdmin({ ...asking, timers, address: world.address.read }))
    .with(CONTROL_PAGES, createControlPages(rest, timers))
    .with(ACTIONS, actions)
    .with(ALARM_LOG, alarmLog)
    .with(PARAMETER_REQUESTS, createParameterActions(parameterValues, asking))
    .with(MISSIONS, createPlanActions(plans, world.saveFile, asking))
    .with(AHRS, createAhrs3d(asking))
    .with(SOURCE_RETURN, sourceReturn)
    .with(SELECTION, createSelection())
    .with(SERVO_SLIDERS, servos.sliders)
    .with(GAMEPADS, gamepads.gamepads)
    .with(TOUCH_STICK, gamepads.touchStick)
    .with(BOARD_CONSOLE, boardConsole)
    .with(FLIGHTS, flights)
    .with(FLIGHT_LOG, book.flightLog)
    .with(CHECKLIST, book.checklist)
    .with(FLIGHT_COMPARISON, comparison)
    .with(PLOTS, plots)
    .with(REPORTS, reports)
    .with(INSPECTOR, createInspector(rest))
    .with(EMULATION, createEmulation(asking))
    .with(ABOUT, createAbout(asking));
  const page: Page = {
    telemetry,
    pump,
    connection,
    admission,
    commands,
    messages,
    settings,
    parts,
    past: null,
    key: 0,
    saveFile: world.saveFile,
  };
  const pasts = createPasts({
    present: page,
    asking,
    timers,
    playback,
    dial: world.dialFlight,
    onMalformed: malformed,
    report: fail,
  });
  parts.with(SHOWN, pasts.shown);
  return {
    page,
    start: () => {
      begin();
      world.versions.onNewer((load) => newVersion.setState({ load }));
      openAddressedTab(settings, addressed.tab);
      gamepads.start();
      const report = addressedReport(world.address.read());
      if (report !== null) {
        choose(settings, "tab", "flights");
        reports.open(report.flight, report.compare);
      }
      const opened = address.opened();
      if (opened !== null) {
        playback.openFlight(opened.flight, opened.at_s);
      }
    },
    stop: () => {
      playback.now();
      gamepads.stop();
      socket.stop();
    },
  };
}
