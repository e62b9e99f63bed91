import type { ReadoutRow, ReadoutRows } from "./LiveReadout";
import { ANGLE, HEADING, TURN_RATE } from "./notations";

export const PITCH_ROLL: readonly ReadoutRow<"pitch_deg" | "roll_deg">[] = [
  { field: "pitch_deg", label: "attitude.pitch", as: ANGLE },
  { field: "roll_deg", label: "attitude.roll", as: ANGLE },
];

export const YAW: ReadoutRow<"yaw_deg"> = { field: "yaw_deg", label: "attitude.heading", as: HEADING };

/** The board's attitude. */
export const ATTITUDE: ReadoutRows = { topic: "ahrs", rows: [YAW, ...PITCH_ROLL] };

/** The board's turn rates about its three axes. */
export const TURN_RATES: ReadoutRows = {
  topic: "inertial",
  rows: [
    { field: "gx_rad_s", label: "axis.p", as: TURN_RATE },
    { field: "gy_rad_s", label: "axis.q", as: TURN_RATE },
    { field: "gz_rad_s", label: "axis.r", as: TURN_RATE },
  ],
};
