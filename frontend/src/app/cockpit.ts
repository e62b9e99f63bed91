import { createAhrs3d } from "../features/ahrs/ahrsRequests";
import { AHRS } from "../features/ahrs/alignment";
import { ALARM_LOG, type AlarmLogStore, forgetOwnAlarm, takeAlarmEvent } from "../features/alarms/alarmLog";
import { createAlarmLog } from "../features/alarms/alarmRequests";
import { createEmulation, EMULATION } from "../features/emulation/emulationRequests";
import { createFaults, FAULTS } from "../features/faults/faultRequests";
import { createInspector, INSPECTOR } from "../features/messages/inspectorRequests";
import { lineLawOf } from "../features/parameters/lineLawOfGains";
import { createParameterActions, takeParameterEvent } from "../features/parameters/parameterRequests";
import { createParameters, forget, PARAMETER_REQUESTS } from "../features/parameters/parameterValues";
import { BOARD_CONSOLE } from "../features/setup/consoleLog";
import { createBoardConsole } from "../features/setup/consoleRequests";
import { createDoctor, DOCTOR } from "../features/setup/doctor";
import { LINE_LAW } from "../missions/lineLaw";
import { createPlanActions, takePlanEvent, takePlanStatus } from "../missions/missionRequests";
import { createPlans, MISSIONS, type PlanStore } from "../missions/planDrafts";
import { createSelection, SELECTION } from "../missions/selection";
import { ACTIONS, createActions } from "../requests/actions";
import type { Parts } from "../store/parts";
import { linkMessages } from "./announcements";
import { type Controls, createControls } from "./controls";
import type { Core } from "./core";

/** What flies: the board with its gains and plans, the controls, and the alarms. */
export interface Cockpit extends Controls {
  readonly plans: PlanStore;
  readonly gains: ReturnType<typeof createParameters>;
  readonly alarms: AlarmLogStore;
  /** The line is not open: what the board has is not known. */
  readonly lost: () => void;
  readonly shutOut: () => void;
}

/** `offer` sends on the stream what is worth nothing later. */
export function createCockpit(core: Core, offer: (text: string) => void): Cockpit {
  const { client, tell, world } = core;
  const gains = createParameters();
  const gainActions = createParameterActions(gains, core);
  const plans = createPlans(world.storage);
  const { boardConsole, takeEvent: takeConsole } = createBoardConsole(core);
  const actions = createActions(core);
  const controls = createControls(core, actions.setStick, offer);
  const alarmLog = alarmLogOf(core);
  return {
    ...controls,
    plans,
    gains,
    alarms: alarmLog.store,
    addTo: (parts) =>
      withTools(controls.addTo(parts), core)
        .with(ACTIONS, actions)
        .with(ALARM_LOG, alarmLog)
        .with(PARAMETER_REQUESTS, gainActions)
        .with(LINE_LAW, lineLawOf(gainActions))
        .with(MISSIONS, createPlanActions(plans, world.saveFile, core))
        .with(BOARD_CONSOLE, boardConsole),
    takeStatus: (before, status) => {
      controls.takeStatus(before, status);
      linkMessages(before, status).forEach(tell);
      takePlanStatus(plans, before?.board ?? null, status.board);
    },
    takeEvent: (message) => {
      controls.takeEvent(message);
      takeConsole(message);
      takeParameterEvent(gains, message, core.wall_ms());
      takePlanEvent(plans, message, client());
      takeAlarmEvent(alarmLog.store, message);
    },
    lost: () => forget(gains),
    shutOut: () => forgetOwnAlarm(alarmLog.store),
  };
}

function alarmLogOf({ vehicle, world, ...core }: Core): ReturnType<typeof createAlarmLog> {
  const { connection, telemetry } = vehicle;
  const { sounder, speaker } = world;
  return createAlarmLog({ ...core, connection, telemetry, sounder, speaker });
}

/** What hears nothing from the stream. */
function withTools(parts: Parts, core: Core): Parts {
  return parts
    .with(AHRS, createAhrs3d(core))
    .with(SELECTION, createSelection())
    .with(INSPECTOR, createInspector(core.rest))
    .with(EMULATION, createEmulation(core))
    .with(FAULTS, createFaults(core))
    .with(DOCTOR, createDoctor(core));
}
