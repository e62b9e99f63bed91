import { expect, test } from "vitest";
import type { Alarm } from "../../protocol/contract";
import { aStatus } from "../../test/aStatus";
import { type EndedAlarm, endedAlarms } from "./endedAlarms";

const OWN: EndedAlarm = { id: "own", level: "critical", text: "not heard", until_s: 20, count: 1 };

function listed(id: string, until_s: number | null): Alarm {
  return {
    id,
    level: "warning",
    since_s: 10,
    until_s,
    text: "said",
    params: {},
    acknowledged: false,
    count: 1,
  };
}

const status = aStatus({ alarms: [listed("first", 15), listed("lasting", null), listed("last", 30)] });

test("what ended stands in the order of its end, the page's own among it; what lasts is not there", () => {
  expect(endedAlarms({ phase: "open", status }, OWN).map(({ id }) => id)).toEqual(["last", "own", "first"]);
});

test("without the gateway nothing that it listed can be acknowledged, and is not shown", () => {
  expect(endedAlarms({ phase: "waiting", status }, OWN)).toEqual([OWN]);
  expect(endedAlarms({ phase: "connecting", status: null }, null)).toEqual([]);
});
