import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import { Station } from "../../test/station";

const user = userEvent.setup();
let station: Station;

const plan: readonly Waypoint[] = [
  { latitude_deg: 27.9515, longitude_deg: -15.3741, altitude_ft: 700, speed_kt: 55 },
  { latitude_deg: 27.9503, longitude_deg: -15.3573, altitude_ft: 1000, speed_kt: 55 },
  { latitude_deg: 27.9239, longitude_deg: -15.3707, altitude_ft: 1000, speed_kt: 60 },
];

function cell(field: keyof Waypoint, row: number): HTMLInputElement {
  const found = document.querySelector<HTMLInputElement>(`[data-row="${row}"][data-field="${field}"]`);
  if (found === null) throw new Error(`there is no ${field} in row ${row}`);
  return found;
}

describe("a plan of a moment of the past", () => {
  const nothing = {
    station: null,
    board: null,
    firmware: null,
    aircraft: null,
    operator: null,
    emulated: false,
  };

  async function known(flight: readonly Waypoint[] | null, at_s = 100): Promise<void> {
    await station.answered("known", {
      at_s,
      identity: nothing,
      parameters: null,
      own: null,
      missions: { flight: flight && { plan: "flight", waypoints: flight }, hil: null },
    });
  }

  async function inThePast(): Promise<void> {
    station = new Station();
    station.greet();
    station.openTab("plans");
    station.openFlight("current", 100);
  }

  test("is the one that the board had then, and cannot be edited", async () => {
    await inThePast();
    expect(station.replay.questions).toHaveLength(1);
    await known(plan);
    expect(cell("altitude_ft", 1).readOnly).toBe(true);
    expect(cell("altitude_ft", 1).value).toBe("1000");
    expect(screen.queryByText("igual que en la placa")).not.toBeNull();
    expect(screen.getByRole("button", { name: "Insertar" }).getAttribute("aria-disabled")).toBe("true");
    cell("altitude_ft", 1).focus();
    await user.keyboard("{Alt>}{Delete}{/Alt}");
    expect(cell("altitude_ft", 2).value).toBe("1000");
  });

  test("is asked for again at another moment, forward too; unknown, it says so", async () => {
    await inThePast();
    await known(plan);
    station.replayed((replay) => replay.position({ at_s: 200, jumps: 2 }));
    expect(station.replay.questions).toHaveLength(2);
    await known(null, 200);
    expect(screen.queryByText(/La grabación no dice qué plan/)).not.toBeNull();
  });

  test("is forgotten when the replay does not answer", async () => {
    await inThePast();
    await known(plan);
    station.replayed((replay) => replay.position({ at_s: 200, jumps: 2 }));
    station.pass(300);
    expect(screen.queryByText(/La grabación no dice qué plan/)).not.toBeNull();
  });
});
