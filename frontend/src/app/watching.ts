import type { AlarmLogState } from "../features/alarms/alarmLog";
import { activeAlarms } from "../features/alarms/raisedAlarms";
import type { AutomaticCheck } from "../features/checklist/checklist";
import type { ParameterStore } from "../features/parameters/parameterValues";
import type { PlanStore } from "../missions/planDrafts";
import { PARAMETERS } from "../protocol/messages.gen";
import type { ConnectionStore } from "../store/connection";
import type { TelemetryStore } from "../store/telemetry";

/** Where the page sees it. */
export interface WatchedMoment {
  readonly telemetry: TelemetryStore;
  readonly connection: ConnectionStore;
  readonly plans: PlanStore;
  readonly gains: ParameterStore;
  readonly alarms: { readonly getState: () => Pick<AlarmLogState, "own" | "restart"> };
  readonly now_ms: () => number;
}

/**
 * What the page sees of the present for the lines of the checklist. Whatever is not live is not seen: without the
 * gateway nothing is.
 */
export function watching(parts: WatchedMoment): (watched: AutomaticCheck) => boolean {
  const { telemetry, connection, plans, gains, alarms, now_ms } = parts;
  const isOpen = (): boolean => connection.getState().phase === "open";
  const active = () => {
    const { own, restart } = alarms.getState();
    return activeAlarms(connection.getState(), own, restart);
  };
  const seen: Readonly<Record<AutomaticCheck, () => boolean>> = {
    gps: () => telemetry.liveFlag("gps", "valid", now_ms()) === true,
    battery: () =>
      (telemetry.liveNumber("analog", "battery_v", now_ms()) ?? 0) > 0 &&
      !active().some(({ id }) => id === "battery_low"),
    gains: () => {
      const { held } = gains.getState();
      return PARAMETERS.every(({ name }) => held[name].value !== null);
    },
    plan: () => {
      const { flight, hil } = plans.getState();
      return (flight.board ?? []).length > 0 || (hil.board ?? []).length > 0;
    },
    recorder: () => {
      const recording = connection.getState().status?.recording;
      return recording?.active === true && recording.failure === null;
    },
    alarms: () => active().length === 0,
  };
  return (watched) => isOpen() && connection.getState().status?.board.state === "open" && seen[watched]();
}
