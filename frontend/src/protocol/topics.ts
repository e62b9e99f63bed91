import { FIELDS, type Telemetry } from "./messages.gen";

/** What X-Plane's rows say, by the names of the definition; null until a row has arrived. */
export interface SimulatorValues {
  readonly indicated_airspeed_kt: number | null;
  readonly mach: number | null;
  readonly vvi_ft_min: number | null;
  readonly g_normal: number | null;
  readonly g_axial: number | null;
  readonly g_side: number | null;
  readonly p_rad_s: number | null;
  readonly q_rad_s: number | null;
  readonly r_rad_s: number | null;
  readonly pitch_deg: number | null;
  readonly roll_deg: number | null;
  readonly true_heading_deg: number | null;
  readonly alpha_deg: number | null;
  readonly beta_deg: number | null;
  readonly horizontal_path_deg: number | null;
  readonly vertical_path_deg: number | null;
  readonly latitude_deg: number | null;
  readonly longitude_deg: number | null;
  readonly altitude_msl_ft: number | null;
  readonly altitude_indicated_ft: number | null;
  readonly stick_elevator: number | null;
  readonly stick_aileron: number | null;
  readonly stick_rudder: number | null;
  readonly throttle_command: number | null;
}

/** The attitude of the AHRS test, in which the board sends nothing else. */
export interface AhrsTestValues {
  readonly yaw_deg: number | null;
  readonly pitch_deg: number | null;
  readonly roll_deg: number | null;
}

/** Values of every topic of the stream: the board's messages, its AHRS test, and the simulator's rows. */
export interface Topics extends Telemetry {
  readonly ahrs_test: AhrsTestValues;
  readonly simulator: SimulatorValues;
}

export type TopicName = keyof Topics;
/** A field of a topic, by name. */
export type FieldName<T extends TopicName> = keyof Topics[T] & string;
/** Fields of a topic which are numbers, and which are flags. */
export type NumberField<T extends TopicName> = {
  [F in FieldName<T>]: Topics[T][F] extends number | null ? F : never;
}[FieldName<T>];
export type FlagField<T extends TopicName> = {
  [F in FieldName<T>]: Topics[T][F] extends boolean | null ? F : never;
}[FieldName<T>];

const SIMULATOR_FIELDS: Readonly<Record<keyof SimulatorValues, "number">> = {
  indicated_airspeed_kt: "number",
  mach: "number",
  vvi_ft_min: "number",
  g_normal: "number",
  g_axial: "number",
  g_side: "number",
  p_rad_s: "number",
  q_rad_s: "number",
  r_rad_s: "number",
  pitch_deg: "number",
  roll_deg: "number",
  true_heading_deg: "number",
  alpha_deg: "number",
  beta_deg: "number",
  horizontal_path_deg: "number",
  vertical_path_deg: "number",
  latitude_deg: "number",
  longitude_deg: "number",
  altitude_msl_ft: "number",
  altitude_indicated_ft: "number",
  stick_elevator: "number",
  stick_aileron: "number",
  stick_rudder: "number",
  throttle_command: "number",
};

const AHRS_TEST_FIELDS: Readonly<Record<keyof AhrsTestValues, "number">> = {
  yaw_deg: "number",
  pitch_deg: "number",
  roll_deg: "number",
};

type Kind = "number" | "boolean";

function kinds(
  fields: Readonly<Record<string, { readonly kind: string }>>,
): ReadonlyArray<readonly [string, Kind]> {
  return Object.entries(fields).map(([name, { kind }]) => [name, kind === "boolean" ? "boolean" : "number"]);
}

/** Every field that a sample of a topic must have, with the type of its value where that is not null. */
export const FIELD_KINDS: ReadonlyMap<string, ReadonlyArray<readonly [string, Kind]>> = new Map([
  ...Object.entries(FIELDS).map(([topic, fields]) => [topic, kinds(fields)] as const),
  ["ahrs_test", Object.entries(AHRS_TEST_FIELDS)] as const,
  ["simulator", Object.entries(SIMULATOR_FIELDS)] as const,
]);
