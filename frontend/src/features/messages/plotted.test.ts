import { expect, test } from "vitest";
import { fieldKey, MOST_PLOTTED, ownKey, parsePlotted, rowValue, signalOf, toggled } from "./plotted";

test("a number of a message stands under its topic and name, with its unit as people write it", () => {
  expect(fieldKey("ahrs", "roll_deg")).toBe("ahrs.roll_deg");
  expect(signalOf("ahrs.roll_deg", "xp10")).toMatchObject({ topic: "ahrs", field: "roll_deg", unit: "°" });
  expect(signalOf("fly_by_wire.aileron", "xp10")).toMatchObject({ unit: "" });
});

test("a number of a topic that the board describes is drawn with the unit that the board says, once it is known", () => {
  const key = ownKey("filter", "bias_x_rad_s");
  const units = new Map([[key, "rad/s"]]);
  expect(signalOf(key, "xp10", units)).toMatchObject({
    topic: "filter",
    field: "bias_x_rad_s",
    unit: "rad/s",
  });
  expect(signalOf(key, "xp10")).toMatchObject({ label: "filter.bias_x_rad_s", unit: "" });
  expect(parsePlotted(`${key} own.filter own.Filter.x`, "xp10")).toEqual([key]);
});

test("what is no number, or on no stream of the page, cannot be drawn", () => {
  expect(fieldKey("heartbeat", "ahrs")).toBeNull();
  expect(fieldKey("acknowledgement", "result")).toBeNull();
  expect(fieldKey("ahrs", "no_such_field")).toBeNull();
  expect(signalOf("ahrs", "xp10")).toBeNull();
});

test("a value of a row means what the profile says", () => {
  expect(rowValue("xp10", 16, 0)).toEqual({ name: "q_rad_s", unit: "rad/s" });
  expect(rowValue("xp12", 16, 0)).toEqual({ name: "p_deg_s", unit: "°/s" });
  expect(signalOf("row.17.1", "xp10")).toMatchObject({ row: 17, index: 1, label: "17: roll_deg", unit: "°" });
  expect(signalOf("row.99.7", "xp10")).toMatchObject({ row: 99, index: 7, label: "99: 7", unit: "" });
  expect(signalOf("row.17.8", "xp10")).toBeNull();
});

test("what was remembered is read with care: each once, no more than can be told apart", () => {
  expect(parsePlotted(undefined, "xp10")).toEqual([]);
  expect(parsePlotted("ahrs.roll_deg nonsense ahrs.roll_deg row.3.0", "xp10")).toEqual([
    "ahrs.roll_deg",
    "row.3.0",
  ]);
  const many = Array.from({ length: 8 }, (_, index) => `row.3.${index}`).join(" ");
  expect(parsePlotted(many, "xp10")).toHaveLength(MOST_PLOTTED);
});

test("a key is taken in and out again", () => {
  expect(toggled(["a"], "b")).toEqual(["a", "b"]);
  expect(toggled(["a", "b"], "a")).toEqual(["b"]);
});
