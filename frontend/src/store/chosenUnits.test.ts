import { describe, expect, test } from "vitest";
import {
  AS_SENT,
  chooseUnit,
  QUANTITIES,
  unitChoice,
  unitDigits,
  unitOfField,
  unitsOf,
  usualUnit,
} from "./chosenUnits";
import { createSettings } from "./settings";

describe("the chosen unit", () => {
  test("is the usual one until somebody chooses; a distance keeps the sender's", () => {
    const settings = createSettings(null, []);
    expect(QUANTITIES.map((quantity) => unitChoice(settings.getState(), quantity))).toEqual([
      "ft",
      "kt",
      "ftPerMin",
      AS_SENT,
      "degC",
    ]);
  });

  test("of one quantity leaves the others alone, and goes back", () => {
    const settings = createSettings(null, []);
    chooseUnit(settings, "altitude", "m");
    expect(unitChoice(settings.getState(), "altitude")).toBe("m");
    expect(unitChoice(settings.getState(), "distance")).toBe(AS_SENT);
    chooseUnit(settings, "altitude", AS_SENT);
    expect(unitChoice(settings.getState(), "altitude")).toBe(AS_SENT);
  });

  test("that the quantity does not have is no choice", () => {
    const settings = createSettings(null, []);
    chooseUnit(settings, "altitude", "kt");
    expect(unitChoice(settings.getState(), "altitude")).toBe("ft");
  });
});

test("every quantity has more than one unit, and its usual one is among them", () => {
  for (const quantity of QUANTITIES) {
    expect(unitsOf(quantity).length).toBeGreaterThan(1);
    expect(unitsOf(quantity)).toContain(usualUnit(quantity));
  }
});

test("each quantity offers these units, the usual one first, with no more decimals than its sensor resolves", () => {
  const offered = QUANTITIES.map((quantity) => [
    quantity,
    unitsOf(quantity)
      .map((unit) => `${unit} ${unitDigits(quantity, unit)}`)
      .join(", "),
  ]);
  expect(Object.fromEntries(offered)).toEqual({
    altitude: "ft 0, m 1",
    speed: "kt 1, kmPerH 1, mPerS 1",
    verticalSpeed: "ftPerMin 0, mPerS 1",
    distance: "m 0, km 2, nm 2",
    temperature: "degC 1, degF 1",
  });
  expect(QUANTITIES.map(usualUnit)).toEqual(["ft", "kt", "ftPerMin", "m", "degC"]);
});

test("a metre of altitude has a tenth, a metre of distance has none", () => {
  expect([unitDigits("altitude", "m"), unitDigits("distance", "m")]).toEqual([1, 0]);
});

test.each([
  ["vvi_ft_min", "ftPerMin"],
  ["altitude_msl_ft", "ft"],
  ["calibrated_airspeed_kt", "kt"],
  ["distance_m", "m"],
  ["temperature_degc", "degC"],
] as const)("%s comes in %s", (field, unit) => {
  expect(unitOfField(field)).toBe(unit);
});

test("a field without such a unit is refused", () => {
  expect(() => unitOfField("roll_deg")).toThrow("roll_deg");
});
