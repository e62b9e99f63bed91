import { expect, test } from "vitest";
import { type Automatics, followSource, NOTHING_LEFT_OFF, type SourceReturn } from "./sourceReturn";

const JOYSTICK: Automatics = { source: "joystick", autopilot: true, autotrim: true };
const OFF = { autopilot: false, autotrim: false };
const RC: Automatics = { source: "rc", ...OFF };

function after(...heard: readonly Automatics[]): SourceReturn {
  return heard.reduce(followSource, NOTHING_LEFT_OFF);
}

test("what was on before RC and is off after it was left off", () => {
  expect(after(JOYSTICK, RC, { ...JOYSTICK, ...OFF }).leftOff).toEqual(["autopilot", "autotrim"]);
  expect(after(JOYSTICK, RC, { ...JOYSTICK, autotrim: false }).leftOff).toEqual(["autotrim"]);
});

test("what was off before RC is not missed after it", () => {
  expect(after({ ...JOYSTICK, ...OFF }, RC, { ...JOYSTICK, ...OFF }).leftOff).toEqual([]);
});

test("nothing is left off while RC is the source, nor without RC between", () => {
  expect(after(JOYSTICK, RC).leftOff).toEqual([]);
  expect(after(JOYSTICK, { ...JOYSTICK, ...OFF }).leftOff).toEqual([]);
  expect(after(RC, { ...JOYSTICK, ...OFF }).leftOff).toEqual([]);
});

test("what is switched on again is not left off any more, and does not come back when it is switched off", () => {
  const back = [JOYSTICK, RC, { ...JOYSTICK, ...OFF }];
  expect(after(...back, { ...JOYSTICK, autotrim: false }).leftOff).toEqual(["autotrim"]);
  expect(after(...back, JOYSTICK, { ...JOYSTICK, ...OFF }).leftOff).toEqual([]);
});

test("it is remembered over a second stay with RC", () => {
  expect(after(JOYSTICK, RC, { ...JOYSTICK, ...OFF }, RC, { ...JOYSTICK, ...OFF }).leftOff).toEqual([
    "autopilot",
    "autotrim",
  ]);
});

test("a heartbeat that says the same changes nothing", () => {
  const state = after(JOYSTICK, RC, { ...JOYSTICK, ...OFF });
  expect(followSource(state, { ...JOYSTICK, ...OFF })).toBe(state);
});
