import { expect, test } from "vitest";
import { ManualTimers } from "../../test/wire";
import { createFlightAddress } from "./flightAddress";

function addressAt(begin: string) {
  const timers = new ManualTimers();
  const written: string[] = [];
  let now = begin;
  const address = createFlightAddress(
    {
      read: () => now,
      replace: (next) => {
        now = next;
        written.push(next);
      },
    },
    timers,
  );
  return { address, timers, written };
}

test("changes at most once a second while a flight plays, and ends at the newest moment", () => {
  const { address, timers, written } = addressAt("http://station/?rate=60#top");
  for (let at_s = 0; at_s < 3; at_s += 0.1) {
    address.keep({ flight: "current", at_s });
    timers.pass(100);
  }
  timers.pass(2000);
  expect(written.length).toBeLessThanOrEqual(5);
  expect(written.at(-1)).toBe("http://station/?rate=60&flight=current&at=2.90#top");
});

test("is without the flight at once when the present is back, and stays so", () => {
  const { address, timers, written } = addressAt("http://station/");
  address.keep({ flight: "current", at_s: 1 });
  address.keep({ flight: "current", at_s: 2 });
  address.keep(null);
  timers.pass(5000);
  expect(written.at(-1)).toBe("http://station/");
});

test("with a moment that is no number opens the flight's start", () => {
  expect(addressAt("http://station/?flight=20260131T120000Z-2&at=soon").address.opened()).toEqual({
    flight: "20260131T120000Z-2",
    at_s: 0,
  });
});
