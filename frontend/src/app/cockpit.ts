import { createAhrs3d } from "../features/ahrs/ahrsRequests";
import { AHRS } from "../features/ahrs/alignment";
import { ALARM_LOG, type AlarmLogStore, forgetOwnAlarm, takeAlarmEvent } from "../features/alarms/alarmLog";
import { createAlarmLog } from "../features/alarms/alarmRequests";
import {
  createSourceReturn,
  NOTHING_LEFT_OFF,
  SOURCE_RETURN,
  takeHeartbeats,
} from "../features/controls/sourceReturn";
import { createEmulation, EMULATION } from "../features/emulation/emulationRequests";
import { createGamepadInput } from "../features/gamepad/gamepadInput";
import { GAMEPADS } from "../features/gamepad/gamepadList";
import { TOUCH_STICK } from "../features/gamepad/touchStick";
import { createInspector, INSPECTOR } from "../features/messages/inspectorRequests";
import { createParameterActions, takeParameterEvent } from "../features/parameters/parameterRequests";
import { createParameters, forget, PARAMETER_REQUESTS } from "../features/parameters/parameterValues";
import { SERVO_SLIDERS } from "../features/servos/servoPositions";
import { createServoSliders } from "../features/servos/servoSliders";
import { BOARD_CONSOLE } from "../features/setup/consoleLog";
import { createBoardConsole } from "../features/setup/consoleRequests";
import { createPlanActions, takePlanEvent, takePlanStatus } from "../missions/missionRequests";
import { createPlans, MISSIONS, type PlanStore } from "../missions/planDrafts";
import { createSelection, SELECTION } from "../missions/selection";
import type { Batch } from "../protocol/envelope";
import { ACTIONS, createActions } from "../requests/actions";
import { linkMessages } from "./announcements";
import type { Core, Group } from "./core";

/** What flies: the board with its gains and plans, the controls, and the alarms. */
export interface Cockpit extends Required<Group> {
  readonly plans: PlanStore;
  readonly gains: ReturnType<typeof createParameters>;
  readonly alarms: AlarmLogStore;
  readonly takeSamples: (samples: Batch["samples"]) => void;
  /** The line is not open: what the board has is not known. */
  readonly lost: () => void;
  readonly shutOut: () => void;
  readonly start: () => void;
  readonly stop: () => void;
}

/** `offer` sends on the stream what is worth nothing later. */
export function createCockpit(core: Core, offer: (text: string) => void): Cockpit {
  const { rest, timers, vehicle, settings, client, tell, world } = core;
  const { connection, telemetry } = vehicle;
  const gains = createParameters();
  const plans = createPlans(world.storage);
  const sourceReturn = createSourceReturn();
  const servos = createServoSliders({ rest, timers, client, tell });
  const { boardConsole, takeEvent: takeConsole } = createBoardConsole(core);
  const actions = createActions(core);
  const { sounder, speaker } = world;
  const alarmLog = createAlarmLog({ ...core, connection, telemetry, sounder, speaker });
  const gamepads = createGamepadInput({
    reader: world.gamepads,
    timers,
    connection,
    settings,
    setStick: actions.setStick,
    send: offer,
    tell,
    report: core.fail,
  });
  return {
    plans,
    gains,
    alarms: alarmLog.store,
    addTo: (parts) =>
      parts
        .with(ACTIONS, actions)
        .with(ALARM_LOG, alarmLog)
        .with(PARAMETER_REQUESTS, createParameterActions(gains, core))
        .with(MISSIONS, createPlanActions(plans, world.saveFile, core))
        .with(AHRS, createAhrs3d(core))
        .with(SOURCE_RETURN, sourceReturn)
        .with(SELECTION, createSelection())
        .with(SERVO_SLIDERS, servos.sliders)
        .with(GAMEPADS, gamepads.gamepads)
        .with(TOUCH_STICK, gamepads.touchStick)
        .with(BOARD_CONSOLE, boardConsole)
        .with(INSPECTOR, createInspector(rest))
        .with(EMULATION, createEmulation(core)),
    takeStatus: (before, status) => {
      servos.takeStatus(status);
      linkMessages(before, status).forEach(tell);
      takePlanStatus(plans, before?.board ?? null, status.board);
      if (before !== null && before.board.url !== status.board.url) {
        sourceReturn.setState(NOTHING_LEFT_OFF);
      }
    },
    takeSamples: (samples) => takeHeartbeats(sourceReturn, samples),
    takeEvent: (message) => {
      servos.takeEvent(message);
      takeConsole(message);
      takeParameterEvent(gains, message, core.wall_ms());
      takePlanEvent(plans, message, client());
      gamepads.takeEvent(message);
      takeAlarmEvent(alarmLog.store, message);
      if (message.event === "board_restarted") {
        // Its restart is reported on its own, with all that it switched off.
        sourceReturn.setState(NOTHING_LEFT_OFF);
      }
    },
    lost: () => forget(gains),
    shutOut: () => forgetOwnAlarm(alarmLog.store),
    start: gamepads.start,
    stop: gamepads.stop,
  };
}
