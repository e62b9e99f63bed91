import { FIELDS, type Telemetry } from "./messages.gen";

/** What X-Plane's rows say, by the names of the definition; null until a row has arrived. */
const SIMULATOR_FIELDS = [
  "indicated_airspeed_kt",
  "mach",
  "vvi_ft_min",
  "g_normal",
  "g_axial",
  "g_side",
  "p_rad_s",
  "q_rad_s",
  "r_rad_s",
  "pitch_deg",
  "roll_deg",
  "true_heading_deg",
  "alpha_deg",
  "beta_deg",
  "horizontal_path_deg",
  "vertical_path_deg",
  "latitude_deg",
  "longitude_deg",
  "altitude_msl_ft",
  "altitude_indicated_ft",
  "stick_elevator",
  "stick_aileron",
  "stick_rudder",
  "throttle_command",
] as const;

/** The attitude of the AHRS test, in which the board sends nothing else. */
const AHRS_TEST_FIELDS = ["yaw_deg", "pitch_deg", "roll_deg"] as const;

type Numbers<F extends readonly string[]> = Readonly<Record<F[number], number | null>>;

/** Values of every topic of the stream: the board's messages, its AHRS test, and the simulator's rows. */
export interface Topics extends Telemetry {
  readonly ahrs_test: Numbers<typeof AHRS_TEST_FIELDS>;
  readonly simulator: Numbers<typeof SIMULATOR_FIELDS>;
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

type Kind = "number" | "boolean";

function kinds(
  fields: Readonly<Record<string, { readonly kind: string }>>,
): ReadonlyArray<readonly [string, Kind]> {
  return Object.entries(fields).map(([name, { kind }]) => [name, kind === "boolean" ? "boolean" : "number"]);
}

/** Every field that a sample of a topic must have, with the type of its value where that is not null. */
export const FIELD_KINDS: ReadonlyMap<string, ReadonlyArray<readonly [string, Kind]>> = new Map([
  ...Object.entries(FIELDS).map(([topic, fields]) => [topic, kinds(fields)] as const),
  ["ahrs_test", AHRS_TEST_FIELDS.map((name) => [name, "number"] as const)] as const,
  ["simulator", SIMULATOR_FIELDS.map((name) => [name, "number"] as const)] as const,
]);
