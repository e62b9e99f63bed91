import { useEffect } from "react";
import { usePage } from "./hooks";
import type { Paint, PaintRate } from "./pump";
import type { TelemetryStore } from "./telemetry";

/**
 * Paint from the telemetry without React, directly onto the elements of the component's refs: `movement` in each
 * animation frame with news, `text` ten times a second. `paint` must be stable (useCallback), or it is registered
 * again at each render.
 */
export function usePaint(rate: PaintRate, paint: (telemetry: TelemetryStore, now_ms: number) => void): void {
  const { telemetry, pump } = usePage();
  useEffect(() => {
    const run: Paint = (now_ms) => paint(telemetry, now_ms);
    return pump.add(rate, run);
  }, [telemetry, pump, rate, paint]);
}
