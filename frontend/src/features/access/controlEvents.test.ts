import { expect, test } from "vitest";
import type { PageName } from "../../protocol/guards.gen";
import { anEvent, aShape } from "../../test/shapes";
import { controlMessage } from "./controlEvents";

const ana = { client: "a", name: "Ana · tableta", kind: "person", number: 1 } as const;
const station = { client: "s", name: "this computer", kind: "local", number: 1 } as const;
const nobody = { client: null, name: null, kind: null, number: null };

function told(reason: string, to: PageName, before: PageName | null, client: string) {
  const said = controlMessage(anEvent("control", { ...to, reason, before }), client);
  if (said === null) {
    return null;
  }
  const { level, key, params } = said.message;
  return `${level} ${key} ${params["name"]} ${params["before"]}`;
}

test("who gets control hears from whom; a page on the station's computer is named in the user's language", () => {
  expect(told("granted", ana, station, "a")).toBe("info controlGot.granted Ana · tableta @control.station");
  expect(told("asked", ana, null, "a")).toBe("info controlGot.other Ana · tableta ");
});

test("who loses it without having meant it is warned", () => {
  expect(told("taken", station, ana, "a")).toBe("warning controlGone.taken @control.station Ana · tableta");
  expect(told("silent", nobody, ana, "a")).toBe("warning controlGone.silent  Ana · tableta");
  expect(told("handed_over", station, ana, "a")).toBe(
    "info controlGone.other @control.station Ana · tableta",
  );
});

test("everybody else hears who has it now, and is warned when its holder was lost", () => {
  expect(told("granted", ana, station, "x")).toBe("info controlSeen.changed Ana · tableta @control.station");
  expect(told("lost", nobody, ana, "x")).toBe("warning controlSeen.lost  Ana · tableta");
  expect(told("released", nobody, ana, "x")).toBe("info controlSeen.free  Ana · tableta");
});

test("only who asked hears of a refusal", () => {
  const closed = anEvent("control_request_closed", { ...ana, result: "refused" });
  expect(controlMessage(closed, "a")).toMatchObject({
    message: { key: "controlSeen.refused" },
    isAnswer: true,
  });
  expect(controlMessage(closed, "s")).toBeNull();
  expect(controlMessage({ ...closed, data: { ...ana, result: "given" } }, "a")).toBeNull();
});

test.each([
  ["granted", "a", true],
  ["waited", "a", true],
  ["handed_over", "a", false],
  ["asked", "a", true],
  ["back", "a", false],
  ["granted", "x", false],
])("control that is %s, heard by %s, answers what its user asked: %s", (reason, client, isAnswer) => {
  const event = anEvent("control", { ...ana, reason, before: station });
  expect(controlMessage(event, client)?.isAnswer).toBe(isAnswer);
});

test("an event of something else says nothing of control", () => {
  expect(controlMessage(anEvent("alarm", aShape("AlarmEvent")), "a")).toBeNull();
});
