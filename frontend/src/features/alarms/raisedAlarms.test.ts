import { beforeEach, describe, expect, test } from "vitest";
import type { Status } from "../../protocol/contract";
import { type Connection, createConnection } from "../../store/connection";
import { TelemetryStore } from "../../store/telemetry";
import { aStatus, aTopic } from "../../test/aStatus";
import { activeAlarms, isRecovered } from "./raisedAlarms";

type AlarmRecord = Status["alarms"][number];

function raised(id: string, parts: Partial<AlarmRecord> = {}): AlarmRecord {
  return {
    id,
    level: "warning",
    since_s: 10,
    until_s: null,
    text: "said by the gateway",
    params: {},
    acknowledged: false,
    count: 1,
    ...parts,
  };
}

function open(status: Status): Connection {
  return { ...createConnection().getState(), phase: "open", status };
}

describe("what is wrong now", () => {
  test("is ordered by urgency: not acknowledged, critical, newest", () => {
    const status = aStatus({
      alarms: [
        raised("a", { level: "critical", acknowledged: true }),
        raised("b"),
        raised("c", { since_s: 20 }),
        raised("d", { level: "critical" }),
      ],
    });
    expect(activeAlarms(open(status), null).map(({ id }) => id)).toEqual(["d", "c", "b", "a"]);
  });

  test("has nothing of what recovered and only waits to be acknowledged", () => {
    const status = aStatus({ alarms: [raised("a", { until_s: 12 }), raised("b")] });
    expect(activeAlarms(open(status), null).map(({ id }) => id)).toEqual(["b"]);
  });

  test("is the page's own alarm alone while the gateway is not heard", () => {
    const own = { since_s: 5, acknowledged: false };
    const connection: Connection = { ...open(aStatus({ alarms: [raised("a")] })), phase: "silent" };
    expect(activeAlarms(connection, own)).toMatchObject([
      { id: "gateway_lost", level: "critical", since_s: 5, message: { key: "alarm.gateway_silent" } },
    ]);
    expect(activeAlarms({ ...connection, phase: "waiting" }, null)).toEqual([]);
  });

  test("says where the loop is open, and with a silent GPS that its stream stopped", () => {
    const { simulator } = aStatus();
    const keyOf = (parts: Partial<Status>): string | undefined =>
      activeAlarms(open(aStatus(parts)), null)[0]?.message.key;
    const alarms = [raised("hil_lost")];
    expect(keyOf({ alarms, simulator: { ...simulator, state: "lost" } })).toBe("alarm.hil_lost_simulator");
    expect(keyOf({ alarms, simulator: { ...simulator, missing_rows: [17] } })).toBe("alarm.hil_lost_rows");
    expect(keyOf({ alarms })).toBe("alarm.hil_lost");
    const params = { row: 16, row_name: "angular_velocities", name: "p_rad_s", value: "nan" };
    expect(keyOf({ alarms: [raised("hil_lost", { params })] })).toBe("alarm.hil_lost_value");
    expect(keyOf({ alarms: [raised("gps_lost", { params: { reason: "silent" } })] })).toBe(
      "alarm.gps_lost_silent",
    );
    expect(keyOf({ alarms: [raised("gps_lost", { params: { reason: "no_fix" } })] })).toBe("alarm.gps_lost");
  });
});

describe("recovered", () => {
  const START_S = 1000;
  let telemetry: TelemetryStore;
  const status = aStatus({
    topics: Object.fromEntries(
      ["heartbeat", "analog", "gps", "hil_surfaces"].map((topic) => [topic, aTopic({ stale_after_s: 0.6 })]),
    ),
  });

  beforeEach(() => {
    telemetry = new TelemetryStore();
    telemetry.greet(START_S, 0);
  });

  function hear(topic: string, values: Readonly<Record<string, number | boolean>> = {}): void {
    telemetry.apply(START_S, [{ topic, t_s: START_S, values }], 0);
  }

  test("is said of a heartbeat that is heard on an open line", () => {
    expect(isRecovered("heartbeat_lost", open(status), telemetry, 0)).toBe(false);
    hear("heartbeat");
    expect(isRecovered("heartbeat_lost", open(status), telemetry, 0)).toBe(true);
  });

  test("is said of an alarm that the gateway lists until somebody acknowledges it", () => {
    hear("heartbeat");
    const listed = aStatus({ ...status, alarms: [raised("heartbeat_lost", { until_s: START_S })] });
    expect(isRecovered("heartbeat_lost", open(listed), telemetry, 0)).toBe(true);
  });

  test("is not said when somebody closed the line", () => {
    hear("heartbeat");
    const closed = { ...status, board: { ...status.board, state: "closed" as const } };
    expect(isRecovered("heartbeat_lost", open(closed), telemetry, 0)).toBe(false);
  });

  test("is not said of a battery whose stream has just ended, though its last sample still counts as live", () => {
    hear("analog", { battery_v: 9 });
    telemetry.setStaleAfter([["analog", 0.6]]);
    telemetry.heard(650);
    expect(telemetry.state("analog", 650)).toBe("live");
    expect(isRecovered("battery_low", open(status), telemetry, 650)).toBe(false);
    expect(isRecovered("battery_low", open(status), telemetry, 200)).toBe(true);
  });

  test("is said of the GPS with a valid position alone", () => {
    hear("gps", { valid: false });
    expect(isRecovered("gps_lost", open(status), telemetry, 0)).toBe(false);
    hear("gps", { valid: true });
    expect(isRecovered("gps_lost", open(status), telemetry, 0)).toBe(true);
  });

  test("is never said while the gateway is not heard, of what is still wrong, or of an alarm that is not known", () => {
    hear("heartbeat");
    expect(isRecovered("heartbeat_lost", { ...open(status), phase: "silent" }, telemetry, 0)).toBe(false);
    const still = aStatus({ ...status, alarms: [raised("heartbeat_lost")] });
    expect(isRecovered("heartbeat_lost", open(still), telemetry, 0)).toBe(false);
    expect(isRecovered("something_new", open(status), telemetry, 0)).toBe(false);
    expect(isRecovered("parameter_not_confirmed", open(status), telemetry, 0)).toBe(false);
  });
});
