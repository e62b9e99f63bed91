import { expect, test } from "vitest";
import { createConnection } from "../../store/connection";
import { aStatus } from "../../test/aStatus";
import { aFlightEvent } from "../../test/flights";
import { gatewayOf } from "../../test/gateway";
import { anEvent, aShape } from "../../test/shapes";
import { ManualTimers } from "../../test/wire";
import { createFlightLog } from "./flightLog";

const EVENT = anEvent("alarm", aShape("AlarmEvent"));

function aLog(isRecording = true) {
  const timers = new ManualTimers();
  const connection = createConnection();
  const status = aStatus();
  connection.setState({ status: { ...status, recording: { ...status.recording, active: isRecording } } });
  const asked: string[] = [];
  const answers: Array<(response: Response) => void> = [];
  const rest = gatewayOf((path) => {
    asked.push(path);
    return new Promise((resolve) => answers.push(resolve));
  });
  const tell = () => ({ group: "mark", message: { level: "info", key: "x", params: {} } }) as const;
  return { ...createFlightLog({ rest, timers, connection, tell }), timers, asked, answers };
}

const settled = (): Promise<unknown> => new Promise((done) => setTimeout(done, 0));

test("a burst of events is read once, when the station has recorded it, and only while somebody looks", () => {
  const { flightLog, takeLogEvent, timers, asked } = aLog();
  takeLogEvent(EVENT);
  timers.pass(10_000);
  expect(asked).toEqual([]);
  const leave = flightLog.watch();
  expect(asked).toHaveLength(1);
  takeLogEvent(EVENT);
  takeLogEvent(EVENT);
  expect(asked).toHaveLength(1);
  timers.pass(2000);
  expect(asked).toHaveLength(2);
  takeLogEvent(EVENT);
  leave();
  timers.pass(2000);
  expect(asked).toHaveLength(2);
});

test("an answer that was overtaken by a newer one is left out", async () => {
  const { flightLog, answers } = aLog();
  flightLog.watch();
  flightLog.watch();
  answers[1]?.(Response.json({ events: [aFlightEvent({ at_s: 2 })] }));
  await settled();
  answers[0]?.(Response.json({ events: [aFlightEvent({ at_s: 1 })] }));
  await settled();
  expect(flightLog.store.getState().events?.map(({ at_s }) => at_s)).toEqual([2]);
});

test("while nothing is recorded nothing is asked", () => {
  const { flightLog, asked } = aLog(false);
  flightLog.watch();
  expect(asked).toEqual([]);
});
