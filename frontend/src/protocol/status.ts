import type { AlarmState } from "./guards.gen";

export type { Status } from "./guards.gen";

export type Alarm = AlarmState;
