import type { AlarmState, Status as Generated } from "./guards.gen";

export type Status = Generated & { readonly control: ControlState };

export interface ControlState {
  readonly kind?: "local" | "person" | "program" | null;
  readonly number?: number | null;
  readonly requests?: readonly ControlRequest[];
}

export interface ControlRequest {
  readonly client: string;
  readonly name: string;
  readonly kind: "local" | "person" | "program";
  readonly number: number;
  readonly role: string;
  readonly since_s: number;
  readonly given_at_s: number;
}

export type Alarm = AlarmState;
