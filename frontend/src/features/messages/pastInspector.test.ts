import { beforeEach, expect, test } from "vitest";
import { createConnection } from "../../store/connection";
import { TelemetryStore } from "../../store/telemetry";
import { aStatus, aTopic } from "../../test/aStatus";
import { createPastInspector } from "./pastInspector";

const START_S = 1_700_000_000;
const telemetry = new TelemetryStore();
const connection = createConnection();
const inspector = createPastInspector({ telemetry, connection }, () => 1000);

/** What is listed; a flight of the past always has an answer. */
async function read() {
  const found = await inspector.read();
  if (!("board" in found)) {
    throw new Error("the past gave no answer");
  }
  return found;
}

beforeEach(() => {
  telemetry.greet(START_S, 0);
  connection.setState({ status: null, rates_hz: {} });
});

test("before the flight's status is known nothing is listed, and nothing is said of its line", async () => {
  const { board, link } = await read();
  expect(board).toEqual([]);
  expect(link).toMatchObject({ rx_percent: null, tx_percent: null, simulator_percent: 0 });
  expect(link.round_trip_ms).toEqual({ newest: null, p50: null, p99: null });
});

test("each message of the flight stands with its count, rate, age and values of that moment", async () => {
  const topics = { ahrs: aTopic({ count: 42 }), gps: aTopic(), of_another_board: aTopic() };
  connection.setState({ status: aStatus({ topics }), rates_hz: { ahrs: 49.5 } });
  telemetry.apply(START_S + 0.5, [{ topic: "ahrs", t_s: START_S + 0.5, values: { roll_deg: 12 } }], 500);
  const { t_s, board, link } = await read();
  expect(t_s).toBe(START_S + 1);
  expect(board.map(({ name }) => name)).toEqual(["ahrs", "gps"]);
  const [ahrs, gps] = board;
  expect(ahrs).toMatchObject({
    count: 42,
    rate_hz: 49.5,
    jitter_ms: null,
    values: { roll_deg: 12, pitch_deg: null },
  });
  expect(ahrs?.age_s).toBeCloseTo(0.5);
  // A message that was not heard by then has no values, and no rate of another moment.
  expect(gps).toMatchObject({ rate_hz: 0, age_s: null, values: null });
  expect(link).toMatchObject({ rx_percent: 42.5, round_trip_ms: { p99: 12.5 } });
});

test("rows of the simulator stand with their values", async () => {
  telemetry.applyRows({ t_s: START_S + 0.8, rows: [[17, [1, 2, null, 4, 5, 6, 7, 8]]] });
  const { rows } = await read();
  expect(rows).toHaveLength(1);
  expect(rows[0]).toMatchObject({ row: 17, name: "row_17", values: [1, 2, null, 4, 5, 6, 7, 8] });
});
