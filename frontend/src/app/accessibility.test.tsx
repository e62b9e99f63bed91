import axe from "axe-core";
import { expect, test } from "vitest";
import { aStatus, heldBy } from "../test/aStatus";
import { Station } from "../test/station";

/** The checker is slow in a document without a browser, the more so on a busy machine. */
const LIMIT_MS = 120_000;

async function violations(): Promise<string[]> {
  const found = await axe.run(document, {
    // Colours are computed by a browser; theme/contrast.test.ts holds them.
    rules: { "color-contrast": { enabled: false } },
    resultTypes: ["violations"],
  });
  return found.violations.map(
    ({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(" ")).join(", ")}`,
  );
}

test.each(["fly", "flight", "six", "hil", "messages", "alarms", "setup", "flights"] as const)(
  "the whole page with %s open has nothing that keeps people out",
  async (tab) => {
    document.documentElement.lang = "es";
    document.title = "EPF GCS";
    const station = new Station();
    station.greet();
    station.send({ heartbeat: { ahrs: true, analog: false, source_joystick: true } });
    station.openTab(tab);
    expect(await violations()).toEqual([]);
  },
  LIMIT_MS,
);

test(
  "nor has it in alarm, with a viewer who may do nothing",
  async () => {
    const station = new Station();
    station.greet(
      aStatus({
        control: heldBy("c2", "Ana"),
        alarms: [
          {
            id: "heartbeat_lost",
            level: "critical",
            since_s: 1,
            until_s: null,
            acknowledged: false,
            count: 1,
            text: "Lost.",
            params: { target: "pty" },
          },
          {
            id: "battery_low",
            level: "warning",
            since_s: 1,
            until_s: 2,
            acknowledged: false,
            count: 1,
            text: "Low.",
            params: { battery_v: 9.8 },
          },
        ],
      }),
    );
    expect(await violations()).toEqual([]);
  },
  LIMIT_MS,
);
