import { expect, test } from "vitest";
import { boardUrl, choiceOf, isBaud, OTHER } from "./address";

test("a listed port is opened with the chosen speed", () => {
  expect(boardUrl({ port: "/dev/ttyUSB0", baud: "57600", address: "tcp://ignored:1" })).toBe(
    "serial:///dev/ttyUSB0?baud=57600",
  );
});

test.each(["tcp://127.0.0.1:5760", "pty:///tmp/board", "serial:///dev/ttyS0?baud=9600"])(
  "a written address %s is taken as it stands",
  (address) => {
    expect(boardUrl({ port: OTHER, baud: "115200", address: `  ${address} ` })).toBe(address);
  },
);

test.each([
  ["/dev/ttyACM0", "serial:///dev/ttyACM0?baud=115200"],
  ["COM3", "serial:///COM3?baud=115200"],
])("a bare device name %s is a serial port", (address, url) => {
  expect(boardUrl({ port: null, baud: "115200", address })).toBe(url);
});

test("nothing written is nothing to open", () => {
  expect(boardUrl({ port: OTHER, baud: "115200", address: "  " })).toBeNull();
});

test("a remembered speed which the board does not know is not used", () => {
  expect([isBaud("115200"), isBaud("115201"), isBaud(undefined)]).toEqual([true, false, false]);
});

test.each([
  ["serial:///dev/ttyUSB0?baud=57600", { port: "/dev/ttyUSB0", baud: "57600", address: "" }],
  ["serial:///COM3?baud=115200", { port: "COM3", baud: "115200", address: "" }],
  ["tcp://10.0.0.7:5760", { port: OTHER, baud: "115200", address: "tcp://10.0.0.7:5760" }],
  ["pty:///run/board", { port: OTHER, baud: "115200", address: "pty:///run/board" }],
])("what is open (%s) is what the form shows, and opens the same again", (url, choice) => {
  expect(choiceOf(url)).toEqual(choice);
  expect(boardUrl(choiceOf(url))).toBe(url);
});

test("with nothing open nothing is chosen", () => {
  expect(boardUrl(choiceOf(null))).toBeNull();
});
