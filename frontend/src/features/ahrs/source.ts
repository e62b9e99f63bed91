import type { Vector } from "../../lib/attitude";
import { useConnection } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import type { AttitudeSource } from "./alignment";

/** The source of the attitude: the board's AHRS stream, or its AHRS test, during which it sends nothing else. */
export function useAttitudeSource(): AttitudeSource {
  return useConnection(({ status }) => ((status?.board.ahrs_test ?? "off") === "off" ? "ahrs" : "ahrs_test"));
}

/** The newest accelerometer and magnetometer readings, ahead-right-down; null while not live or incomplete. */
export function liveVectors(
  telemetry: TelemetryStore,
  now_ms: number,
): { readonly acceleration_m_s2: Vector | null; readonly field: Vector | null } {
  const read = (field: "accx_m_s2" | "accy_m_s2" | "accz_m_s2" | "magx" | "magy" | "magz") =>
    telemetry.liveNumber("inertial", field, now_ms);
  return {
    acceleration_m_s2: vector(read("accx_m_s2"), read("accy_m_s2"), read("accz_m_s2")),
    field: vector(read("magx"), read("magy"), read("magz")),
  };
}

export function vector(x: number | null, y: number | null, z: number | null): Vector | null {
  return x === null || y === null || z === null ? null : [x, y, z];
}
