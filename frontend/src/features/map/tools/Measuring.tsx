import { useMeasuring } from "./useMeasuring";

/** The distance tool where there is no panel for it. */
export function Measuring() {
  useMeasuring();
  return null;
}
