import { expect, test } from "vitest";
import {
  dictionary,
  either,
  faultIn,
  isFlag,
  isNumber,
  isObject,
  isText,
  list,
  nullable,
  oneOf,
  optional,
  shape,
} from "./check";

const isPort = shape({
  device: isText,
  baud: nullable(isNumber),
  kind: oneOf("serial", "tcp"),
  tags: list(isText),
  counts: dictionary(isNumber),
  open: isFlag,
  added: optional(isText),
});
const port = {
  device: "/dev/ttyUSB0",
  baud: 115200,
  kind: "serial",
  tags: ["a"],
  counts: { n: 1 },
  open: true,
};

test("a value with all its fields passes, with fields of a newer gateway too", () => {
  expect(isPort(port)).toBe(true);
  expect(isPort({ ...port, baud: null, added_later: 1 })).toBe(true);
});

test("what an older gateway does not tell may be missing, and is of its type where it is there", () => {
  expect(isPort({ ...port, added: "since then" })).toBe(true);
  expect(isPort({ ...port, added: 1 })).toBe(false);
});

test.each([
  ["a missing field", { ...port, device: undefined }],
  ["a field of another type", { ...port, baud: "115200" }],
  ["a number that is not finite", { ...port, baud: Number.POSITIVE_INFINITY }],
  ["an unknown word", { ...port, kind: "radio" }],
  ["a wrong entry in a list", { ...port, tags: ["a", 1] }],
  ["a wrong entry in a dictionary", { ...port, counts: { n: null } }],
  ["null", null],
  ["a list", [port]],
])("%s fails", (_, value) => {
  expect(isPort(value)).toBe(false);
});

test.each([
  ["a field", { ...port, device: 7 }, ".device"],
  ["a missing field", { ...port, kind: undefined }, ".kind"],
  ["an entry of a list", { ...port, tags: ["a", 1] }, ".tags[1]"],
  ["an entry of a dictionary", { ...port, counts: { n: null } }, ".counts.n"],
  ["a list that is none", { ...port, tags: {} }, ".tags"],
  ["the whole", [port], ""],
  ["nothing", port, null],
])("of what does not fit, the fault names %s", (_, value, fault) => {
  expect(faultIn(isPort, value)).toBe(fault);
});

test("one of several types fits, and no other", () => {
  const isTextOrFlags = either(isText, list(isFlag));
  expect([isTextOrFlags("a"), isTextOrFlags([true]), isTextOrFlags(1), isTextOrFlags([1])]).toEqual([
    true,
    true,
    false,
    false,
  ]);
});

test("another shape is made of the fields of one", () => {
  const { device } = isPort.fields;
  const isNamed = shape({ device });
  expect([isNamed({ device: "a" }), isNamed({ device: 1 })]).toEqual([true, false]);
});

test("a list and null are not objects", () => {
  expect([isObject({}), isObject([]), isObject(null)]).toEqual([true, false, false]);
});
