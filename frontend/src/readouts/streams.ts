import type { CommandName } from "../protocol/messages.gen";
import type { FlagField, TopicName } from "../protocol/topics";

export interface Stream {
  /** The heartbeat's flag for it; the two flight plans have none. */
  readonly flag: FlagField<"heartbeat"> | null;
  readonly on: CommandName;
}

/** The board's streams that can be switched, by their topic. */
export const STREAMS: Partial<Readonly<Record<TopicName, Stream>>> = {
  ahrs: { flag: "ahrs", on: "ahrs_on" },
  inertial: { flag: "inertial", on: "inertial_on" },
  analog: { flag: "analog", on: "analog_on" },
  statistics: { flag: "statistics", on: "statistics_on" },
  gps: { flag: "gps", on: "gps_on" },
  servos_in: { flag: "servos", on: "servos_in_on" },
  fly_by_wire: { flag: "fly_by_wire", on: "fly_by_wire_on" },
  fms_plan: { flag: null, on: "fms_plan_on" },
  fms_hil_plan: { flag: null, on: "fms_hil_plan_on" },
};
