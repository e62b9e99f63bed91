import { useCallback, useRef, useState } from "react";
import type { Vector } from "../../lib/attitude";
import { coverageOf, type FieldFit, type FitAnswer, fitField } from "../../lib/ellipsoid";
import { cover, missingSide, type Side } from "../../lib/sphereCover";
import { usePart } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { AHRS } from "./alignment";
import { liveVectors } from "./source";

/** A fit takes some milliseconds, and faster updates could not be read. */
const FIT_EVERY_MS = 500;

export interface Calibration {
  readonly count: number;
  readonly answer: FitAnswer;
  readonly fit: FieldFit | null;
  /** Centre and radius of the readings: the fit's, or a rough estimate. */
  readonly centre: Vector;
  readonly radius: number;
  readonly seen: readonly number[];
  readonly missing: Side | null;
}

/** Everything computed from the readings. */
export function calibrate(points: readonly Vector[]): Calibration {
  const answer = fitField(points);
  const fit = answer.kind === "refused" ? null : answer;
  const { centre, radius } = fit === null ? rough(points) : { centre: fit.offset, radius: fit.radius };
  const seen = cover(points, centre);
  return {
    count: points.length,
    answer:
      fit === null ? { ...answer, coverage: points.length > 0 ? coverageOf(points, centre) : 0 } : answer,
    fit,
    centre,
    radius,
    seen,
    missing: missingSide(seen),
  };
}

/** Middle and half of the readings' range; with too few readings, the values of an ideal sensor. */
function rough(points: readonly Vector[]): { centre: Vector; radius: number } {
  const ends = [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis] ?? 0);
    return [Math.min(...values), Math.max(...values)] as const;
  });
  const half = Math.max(...ends.map(([low, high]) => (high - low) / 2));
  if (points.length === 0 || !(half > 0.4)) {
    return { centre: [0, 0, 0], radius: 1 };
  }
  const [x = 0, y = 0, z = 0] = ends.map(([low, high]) => (low + high) / 2);
  return { centre: [x, y, z], radius: half };
}

interface Collection {
  readonly calibration: Calibration;
  /** Called with each present reading; null while there is none. */
  readonly onReading: (listener: ((reading: Vector | null) => void) | null) => void;
}

/** Collects readings while `isOn`, and fits them a few times a second. */
export function useCalibration(isOn: boolean): Collection {
  const { samples } = usePart(AHRS);
  const [calibration, setCalibration] = useState(() => calibrate(samples.points));
  const listener = useRef<((reading: Vector | null) => void) | null>(null);
  const last = useRef({ at_s: null as number | null, revision: samples.revision, fit_ms: 0 });

  const collect = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const { field } = liveVectors(telemetry, now_ms);
      const at_s = telemetry.newestAt_s("inertial");
      if (isOn && field !== null && at_s !== last.current.at_s) {
        samples.add(field);
      }
      last.current.at_s = at_s;
      listener.current?.(field);
      if (samples.revision !== last.current.revision && now_ms - last.current.fit_ms >= FIT_EVERY_MS) {
        last.current.revision = samples.revision;
        last.current.fit_ms = now_ms;
        setCalibration(calibrate(samples.points));
      }
    },
    [isOn, samples],
  );
  usePaint("movement", collect);

  return {
    calibration,
    onReading: useCallback((told) => {
      listener.current = told;
    }, []),
  };
}
