import { type Check, type Checked, isNumber, isText, list, nullable, oneOf, shape } from "../lib/check";

const isNumbers = list(isNumber);

/** Two times, seconds since the flight's start. */
const isStretch: Check<readonly [number, number]> = Object.assign(
  (value: unknown): value is readonly [number, number] => isNumbers(value) && value.length === 2,
);

/**
 * Where a playback stands. `at_s`: seconds since the flight's start; `t_s`: the same moment in Unix seconds; `edge_s`:
 * how far the recording goes so far.
 */
export const isPlayback = shape({
  flight: isText,
  at_s: isNumber,
  t_s: isNumber,
  state: oneOf("playing", "paused", "ended"),
  rate: isNumber,
  loop: nullable(isStretch),
  duration_s: isNumber,
  edge_s: isNumber,
});
export type PlaybackPosition = Checked<typeof isPlayback>;
