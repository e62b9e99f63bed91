import { expect, test } from "vitest";
import { createStore } from "zustand/vanilla";
import type { FlightEvent } from "../../protocol/guards.gen";
import { aFlightEvent } from "../../test/flights";
import type { AlarmLog } from "./alarmLog";
import { createPastAlarmLog, pastAlarmsOf } from "./pastAlarmLog";

function alarm(
  name: string,
  t_s: number,
  until_s: number | null,
  data: FlightEvent["data"] = {},
): FlightEvent {
  return aFlightEvent({ kind: "alarm", name, t_s, until_s, data });
}

test("the alarms that had ended by the moment that is shown stand newest first, and no later ones", () => {
  const events = [
    alarm("first", 10, 20),
    alarm("last", 15, 40),
    alarm("later", 30, 90),
    alarm("lasting", 30, null),
    aFlightEvent({ kind: "mark", t_s: 5, until_s: 6 }),
  ];
  expect(pastAlarmsOf(events, 40).map(({ id }) => id)).toEqual(["last", "first"]);
  expect(pastAlarmsOf(events, 39).map(({ id }) => id)).toEqual(["first"]);
});

test("an alarm keeps its level, words and values; what a newer station adds does no harm", () => {
  const params = { battery_v: 9.8, who: "board", list: [1], nothing: null };
  const [critical, plain] = pastAlarmsOf(
    [
      alarm("low", 10, 40, { level: "critical", text: "Low.", params, acknowledged: true }),
      alarm("odd", 10, 20, { level: 7, text: null, params: "none" }),
    ],
    100,
  );
  expect(critical).toEqual({
    id: "low",
    level: "critical",
    text: "Low.",
    params: { battery_v: 9.8, who: "board" },
    since_s: 10,
    until_s: 40,
    acknowledged: true,
  });
  expect(plain).toMatchObject({ level: "warning", text: "odd", params: {}, acknowledged: false });
});

test("in the past no alarm is acknowledged and no threshold is set, however it is asked", async () => {
  const asked: string[] = [];
  const refuse = (what: string) => async () => void asked.push(what);
  const live = {
    acknowledge: refuse("acknowledge"),
    acknowledgeAll: refuse("all"),
    readPast: refuse("read"),
    readThresholds: refuse("thresholds"),
    setThreshold: refuse("threshold"),
  } as unknown as AlarmLog;
  const store = createStore(() => ({ events: [alarm("low", 10, 20)] }));
  const log = createPastAlarmLog({ facts: { store }, live, wall_s: () => 15 });
  await log.acknowledge("low", { control: "x" });
  await log.acknowledgeAll();
  await log.readThresholds();
  await log.setThreshold("low", 3, { control: "x" });
  await log.readPast();
  expect(asked).toEqual([]);
  expect(log.store.getState().past).toEqual([]);
});
