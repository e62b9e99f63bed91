import { createStore, type StoreApi } from "zustand/vanilla";
import { createAhrs3d } from "../features/ahrs/ahrsRequests";
import { AHRS } from "../features/ahrs/alignment";
import { ALARM_LOG } from "../features/alarms/alarmLog";
import { createPastAlarmLog } from "../features/alarms/pastAlarmLog";
import { createSourceReturn, SOURCE_RETURN } from "../features/controls/sourceReturn";
import { createMapTool, MAP_TOOL } from "../features/map/tools/mapTool";
import { createPastTrack } from "../features/map/track/pastTrack";
import { TRACK_LOG } from "../features/map/track/trackLog";
import { INSPECTOR } from "../features/messages/inspectorRequests";
import { createPastInspector } from "../features/messages/pastInspector";
import { PARAMETER_REQUESTS } from "../features/parameters/parameterValues";
import { createPastParameters } from "../features/parameters/pastParameters";
import type { PlaceInTime } from "../features/playback/flightAddress";
import type { FlightListener, FlightStream, Playback } from "../features/playback/playbackRequests";
import { SERVO_SLIDERS } from "../features/servos/servoPositions";
import { createServoSliders } from "../features/servos/servoSliders";
import { BOARD_CONSOLE } from "../features/setup/consoleLog";
import { createBoardConsole } from "../features/setup/consoleRequests";
import { LINE_LAW, UNKNOWN_LINE_LAW } from "../missions/lineLaw";
import { createPastPlans } from "../missions/pastPlans";
import { MISSIONS } from "../missions/planDrafts";
import { createSelection, SELECTION } from "../missions/selection";
import type { StreamMessage } from "../protocol/envelope";
import type { RequesterParts } from "../requests/asking";
import { createKnownAt } from "../requests/knownAt";
import { type AskReplay, createStreamQuestions } from "../requests/streamQuestions";
import { FlightClock } from "../store/clock";
import { createCommands } from "../store/commands";
import type { Page } from "../store/hooks";
import { failureMessage } from "../store/messages";
import { partName } from "../store/parts";
import { StreamSocket } from "../transport/socket";
import type { Core } from "./core";
import { createVehicle, type Vehicle } from "./vehicle";

/** The page that the tabs read: the present one, or that of the past. */
export const SHOWN = partName<StoreApi<{ readonly page: Page }>>("shown page");

export interface Pasts {
  readonly shown: StoreApi<{ readonly page: Page }>;
  /** Make a vehicle of the past, show it on every tab, and fill it from a stream of its own. */
  readonly open: (place: () => PlaceInTime, listener: FlightListener) => FlightStream;
  /** Changes whenever something new arrives for the shown vehicle of the past. */
  readonly revision: () => number;
}

/**
 * The past is a second page object: stores and parts of its own, made anew for each flight that is opened. The tabs
 * read the one that is shown, so a value of theirs comes from one of the two and never from both; the present one
 * goes on all the time, and is shown again as it is.
 */
export function createPasts(core: Core, present: Page, playback: Playback): Pasts {
  const shown = createStore<{ readonly page: Page }>(() => ({ page: present }));
  let seen: Vehicle | null = null;
  let revision = 0;
  let made_count = 0;

  function open(place: () => PlaceInTime, listener: FlightListener): FlightStream {
    const questions = createStreamQuestions((text) => socket.ask(text), core.timers);
    const made = createPast({ core, present, playback }, place, questions.ask, ++made_count);
    const { vehicle } = made;
    let refusal: string | null = null;
    const socket: StreamSocket = new StreamSocket({
      dial: (wire) => core.world.dialFlight(place(), wire),
      timers: core.timers,
      wall_ms: core.wall_ms,
      onMessage: (message, at_ms) => {
        made.take(message, at_ms);
        if (message.type === "hello" && message.flight !== null) {
          refusal = null;
          listener.onOpened(message.flight);
        } else if (message.type === "playback") {
          listener.onPosition(message.position);
        } else if (message.type === "event" && message.event === "error" && message.data.code !== refusal) {
          // The line is dialled again and again; once is enough.
          refusal = message.data.code;
          core.tell(failureMessage(message.data, "warning"));
        } else if (message.type === "answer") {
          questions.answered(message.about, message.data);
        }
      },
      onState: ({ kind }) => {
        vehicle.become(kind);
        if (kind !== "open") {
          questions.lost();
        }
        listener.onLine(kind === "open");
      },
      onMalformed: core.malformed,
      report: core.fail,
    });
    seen = vehicle;
    shown.setState({ page: made.page });
    socket.start();
    return {
      ask: (text) => socket.ask(text),
      close: () => {
        socket.stop();
        questions.lost();
        made.stop();
        if (seen === vehicle) {
          // What the pump painted last is of the past: the present must be painted even if nothing new arrives.
          revision += vehicle.telemetry.revision + 1;
          seen = null;
          shown.setState({ page: present });
        }
      },
    };
  }

  return { shown, open, revision: () => revision + (seen?.telemetry.revision ?? 0) };
}

interface Past {
  readonly page: Page;
  readonly vehicle: Vehicle;
  readonly take: (message: StreamMessage, at_ms: number) => void;
  readonly stop: () => void;
}

function createPast(
  { core, present, playback }: { readonly core: Core; readonly present: Page; readonly playback: Playback },
  place: () => PlaceInTime,
  ask: AskReplay,
  key: number,
): Past {
  const { rest, timers, fail: report } = core;
  const vehicle = createVehicle(new FlightClock());
  const client = (): string | null => present.connection.getState().client;
  const moment_ms = (): number => (vehicle.telemetry.clock_s(core.now_ms()) ?? 0) * 1000;
  const pastAsking: RequesterParts = { ...core, commands: createCommands() };
  const servos = createServoSliders({ rest, timers, client, tell: () => undefined });
  const console_ = createBoardConsole({ rest, wall_ms: moment_ms });
  const known = createKnownAt(ask, timers, report);
  const parameters = createPastParameters(known, pastAsking);
  const plans = createPastPlans(known, present.saveFile, pastAsking);
  const track = createPastTrack({ rest, place, report });
  const alarmLog = createPastAlarmLog({
    facts: playback.facts,
    live: present.parts.get(ALARM_LOG),
    wall_s: () => moment_ms() / 1000,
  });
  let { jumps } = vehicle.telemetry;
  /** The jumps of the replay itself, also those forward; null before it has told them. */
  let moments: number | null = null;
  /** It went to another moment, whose samples come next. */
  let isElsewhere = false;

  function take(message: StreamMessage, at_ms: number): void {
    vehicle.take(message, at_ms);
    if (vehicle.telemetry.jumps !== jumps) {
      jumps = vehicle.telemetry.jumps;
      console_.boardConsole.clear();
      servos.forget();
    }
    if (message.type === "hello") {
      moments = null;
    } else if (message.type === "playback" && message.position.jumps !== moments) {
      moments = message.position.jumps;
      isElsewhere = true;
      void known.read();
    } else if (message.type === "batch" && isElsewhere) {
      isElsewhere = false;
      present.pump.hurry();
    }
    if (message.type === "event") {
      servos.takeEvent(message);
      console_.takeEvent(message);
      parameters.takeEvent(message);
      plans.takeEvent(message);
    }
  }

  const page: Page = {
    ...present,
    telemetry: vehicle.telemetry,
    connection: vehicle.connection,
    commands: pastAsking.commands,
    past: place().flight,
    key,
    parts: present.parts
      .but()
      .with(ALARM_LOG, alarmLog)
      .with(PARAMETER_REQUESTS, parameters.actions)
      .with(LINE_LAW, UNKNOWN_LINE_LAW)
      .with(MISSIONS, plans.actions)
      .with(AHRS, createAhrs3d(pastAsking))
      .with(SOURCE_RETURN, createSourceReturn())
      .with(SELECTION, createSelection())
      .with(MAP_TOOL, createMapTool())
      .with(TRACK_LOG, track)
      .with(SERVO_SLIDERS, servos.sliders)
      .with(BOARD_CONSOLE, console_.boardConsole)
      .with(INSPECTOR, createPastInspector(ask)),
  };
  return {
    page,
    vehicle,
    take,
    stop: known.stop,
  };
}
