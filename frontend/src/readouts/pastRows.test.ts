import { expect, test } from "vitest";
import { pastRows } from "./pastRows";
import { type Signal, signalKey } from "./signals";

const ROLL: Signal = { topic: "ahrs", field: "roll_deg", label: "Roll", scale: (value) => 2 * value };
const SUM: Signal = {
  law: "sum",
  operands: ["ahrs.roll_deg", "ahrs.pitch_deg"],
  compute: ([roll = null, pitch = null]) => (roll === null || pitch === null ? null : roll + pitch),
  label: "Sum",
};
const TIMES = { step_s: 0.05, lapse_s: 1 };

function recorded(name: string, at_s: number[], values: Array<number | null>) {
  return { name, at_s, min: values, max: values, unit: "deg", count: at_s.length, mean: null };
}

test("signals of several streams meet in rows: each value is the last one, as long as it is not too old", () => {
  const rows = pastRows(
    {
      ...{ starts_s: 1000, from_s: 0, to_s: 9 },
      signals: [
        recorded("ahrs.roll_deg", [1, 1.5, 1.51, 4], [10, 20, 21, null]),
        recorded("ahrs.pitch_deg", [1.2, 3], [1, 2]),
      ],
    },
    [ROLL, SUM],
    TIMES,
  );
  expect(rows.map(({ time_s, read }) => [time_s, read(signalKey(ROLL)), read(signalKey(SUM))])).toEqual([
    [1001, 20, null],
    [1001.2, 20, 11],
    [1001.5, 40, 21],
    [1003, null, null],
    [1004, null, null],
  ]);
});
