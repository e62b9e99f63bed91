import { expect, test } from "vitest";
import { createParameters } from "../features/parameters/parameterValues";
import { boardHas, createPlans } from "../missions/planDrafts";
import { createConnection } from "../store/connection";
import { TelemetryStore } from "../store/telemetry";
import { aStatus } from "../test/aStatus";
import { watching } from "./watching";

function parts() {
  const connection = createConnection();
  const plans = createPlans(null);
  const quiet = { getState: () => ({ own: null, restart: null }) };
  const telemetry = new TelemetryStore();
  const sees = watching({
    telemetry,
    connection,
    plans,
    gains: createParameters(),
    alarms: quiet,
    now_ms: () => 0,
  });
  return { sees, connection, plans };
}

const WAYPOINT = { latitude_deg: 28, longitude_deg: -15, altitude_ft: 1000, speed_kt: 60 };

test("nothing is seen without the gateway or with a board that is not connected", () => {
  const { sees, connection, plans } = parts();
  boardHas(plans, "flight", [WAYPOINT]);
  const status = aStatus();
  expect([sees("recorder"), sees("plan"), sees("alarms")]).toEqual([false, false, false]);
  connection.setState({ phase: "open", status });
  expect([sees("recorder"), sees("plan"), sees("alarms")]).toEqual([true, true, true]);
  connection.setState({ status: { ...status, board: { ...status.board, state: "lost" } } });
  expect([sees("recorder"), sees("plan"), sees("alarms")]).toEqual([false, false, false]);
});

test("what was never received is not seen: position, battery, gains, a plan that was not read back", () => {
  const { sees, connection, plans } = parts();
  connection.setState({ phase: "open", status: aStatus() });
  boardHas(plans, "flight", []);
  expect([sees("gps"), sees("battery"), sees("gains"), sees("plan")]).toEqual([false, false, false, false]);
});

test("a recording that fails is none", () => {
  const { sees, connection } = parts();
  const status = aStatus();
  const failure = "The disk is full.";
  connection.setState({
    phase: "open",
    status: { ...status, recording: { ...status.recording, failure } },
  });
  expect(sees("recorder")).toBe(false);
});
