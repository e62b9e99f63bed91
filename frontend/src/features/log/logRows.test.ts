import { expect, test } from "vitest";
import type { FlightEvent } from "../../protocol/guards.gen";
import type { SaidMessage } from "../../store/messages";
import { aFlightEvent } from "../../test/flights";
import type { EventMessage } from "./flightLog";
import { EVERYTHING, filtered, logFile, logRows } from "./logRows";

const AT_S = 1_700_000_000;

function said(text: string, at_s: number, level: SaidMessage["level"] = "info"): SaidMessage {
  return { level, key: text, params: {}, number: at_s - AT_S, said_ms: at_s * 1000 };
}

function tell(event: FlightEvent): EventMessage {
  const group = event.kind === "alarm" ? "alarm" : event.kind === "command" ? "command" : "trouble";
  return { group, message: { level: "info", key: event.name, params: {} } };
}

function rows(messages: readonly SaidMessage[], events: readonly FlightEvent[]) {
  return logRows(messages, events, tell, ({ key }) => key);
}

test("messages and events stand in one list, newest first", () => {
  const found = rows(
    [said("opened", AT_S + 1), said("closed", AT_S + 30)],
    [aFlightEvent({ kind: "command", name: "autopilot on", t_s: AT_S + 10 })],
  );
  expect(found.map(({ text, group }) => [text, group])).toEqual([
    ["closed", "page"],
    ["autopilot on", "command"],
    ["opened", "page"],
  ]);
});

test("an outcome that the page said and the station recorded stands once", () => {
  const events = [aFlightEvent({ kind: "command", name: "trim on", t_s: AT_S + 10 })];
  expect(rows([said("trim on", AT_S + 12)], events).map(({ group }) => group)).toEqual(["command"]);
  expect(rows([said("trim on", AT_S + 60)], events)).toHaveLength(2);
});

test("alarms have their own level, trouble is a warning, and a line that opens is none", () => {
  const found = rows(
    [],
    [
      aFlightEvent({ kind: "link", name: "board_opened", t_s: AT_S }),
      aFlightEvent({ kind: "gap", name: "gap", t_s: AT_S + 1 }),
      aFlightEvent({ kind: "alarm", name: "low", t_s: AT_S + 2, data: { level: "warning" } }),
      aFlightEvent({ kind: "alarm", name: "lost", t_s: AT_S + 3, data: { level: "critical" } }),
    ],
  );
  expect(found.map(({ level }) => level)).toEqual(["error", "warning", "warning", "info"]);
});

test("a search finds words in any order, whatever their accents and case", () => {
  const all = rows([said("Alineación del AHRS hecha", AT_S), said("Puerto abierto", AT_S + 1)], []);
  const found = (search: string) => filtered(all, { ...EVERYTHING, search }).map(({ text }) => text);
  expect(found("ahrs ALINEACION")).toEqual(["Alineación del AHRS hecha"]);
  expect(found("ahrs puerto")).toEqual([]);
  expect(found("  ")).toHaveLength(2);
});

test("groups and milder levels can be hidden", () => {
  const all = rows(
    [said("note", AT_S), said("caution", AT_S + 1, "warning"), said("failure", AT_S + 2, "error")],
    [aFlightEvent({ kind: "command", name: "command", t_s: AT_S + 3 })],
  );
  const found = (part: object) => filtered(all, { ...EVERYTHING, ...part }).map(({ text }) => text);
  expect(found({ least: "warning" })).toEqual(["failure", "caution"]);
  expect(found({ least: "error" })).toEqual(["failure"]);
  expect(found({ hidden: ["page"] })).toEqual(["command"]);
});

test("the file has a line for each row, oldest first, and none breaks in two", () => {
  const all = rows([said("two\nlines", AT_S), said("second", AT_S + 1, "error")], []);
  const words = {
    time: (at_s: number) => `${at_s - AT_S}`,
    level: (level: string) => level,
    group: (group: string) => group,
  };
  expect(logFile(all, words)).toBe("0\tinfo\tpage\ttwo lines\n1\terror\tpage\tsecond\n");
});
