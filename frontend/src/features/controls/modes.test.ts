import { expect, test } from "vitest";
import { automaticState } from "./modes";

test("an autopilot that is on acts, unless the simulated aircraft's signal goes past the board: then it is armed", () => {
  expect(automaticState(true, "hil", "assisted")).toBe("active");
  expect(automaticState(true, "hil", "manual")).toBe("armed");
  expect(automaticState(true, "flight", "manual")).toBe("active");
  expect(automaticState(false, "hil", "manual")).toBe("off");
});

test("what no live heartbeat says is not known", () => {
  expect(automaticState(null, "hil", "manual")).toBe("unknown");
  expect(automaticState(null, "flight", null)).toBe("unknown");
});
