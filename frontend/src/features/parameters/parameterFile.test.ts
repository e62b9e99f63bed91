import { describe, expect, test } from "vitest";
import { PARAMETERS } from "../../protocol/messages.gen";
import { type FileLine, type ParameterFile, readParameterFile, writeParameterFile } from "./parameterFile";

const defaults = new Map<string, number>(PARAMETERS.map((one) => [one.name, one.default]));
const board = { name: "epf-board", version: "1.2.0" };
const saved = new Date(Date.UTC(2026, 10, 21, 15, 0, 0));

function opened(text: string): ParameterFile {
  const file = readParameterFile(text, PARAMETERS);
  if (typeof file === "string") {
    throw new Error(`refused as a whole: ${file}`);
  }
  return file;
}

/** A file with these lines instead of the seventeen. */
function fileOf(lines: string, parts = ""): string {
  return `{"format": "epf-gcs-parameters", "version": 1, ${parts} "parameters": [${lines}]}`;
}

function fault(line: string): FileLine["fault"] {
  return opened(fileOf(line)).lines[0]?.fault ?? null;
}

test("what is saved is read back, with the board and the time", () => {
  const file = opened(writeParameterFile(new Map([...defaults, ["k_roll", 2.75]]), board, saved));
  expect(file.saved).toBe("2026-11-21T15:00:00.000Z");
  expect(file.board).toEqual(board);
  expect(file.missing).toEqual([]);
  expect(file.lines.map(({ fault }) => fault)).toEqual(PARAMETERS.map(() => null));
  expect(file.lines.find(({ name }) => name === "k_roll")).toMatchObject({ text: "2.75", value: 2.75 });
});

describe("a line", () => {
  test.each([
    ['{"name": "k_flap", "value": 1}', "unknown"],
    ['{"value": 1}', "no_name"],
    ["3", "no_name"],
    ["null", "no_name"],
    ['{"name": "k_roll", "value": NaN}', "not_a_number"],
    ['{"name": "k_roll", "value": -Infinity}', "not_a_number"],
    ['{"name": "k_roll", "value": "2"}', "not_a_number"],
    ['{"name": "k_roll", "value": null}', "not_a_number"],
    ['{"name": "k_roll"}', "not_a_number"],
    ['{"name": "k_roll", "value": 100}', "out_of_range"],
    ['{"name": "k_roll", "value": -0.01}', "out_of_range"],
    ['{"name": "k_div_velocidad", "value": 700.5}', "not_whole"],
    ['{"name": "k_div_velocidad", "value": 10001}', "out_of_range"],
  ])("%s is told as %s", (line, expected) => {
    expect(fault(line)).toBe(expected);
  });

  test.each([
    ['{"name": "k_roll", "value": 0}', 0],
    ['{"name": "k_roll", "value": 99.99}', 99.99],
    ['{"name": "k_div_velocidad", "value": 700}', 700],
  ])("%s is taken", (line, value) => {
    expect(opened(fileOf(line)).lines[0]).toMatchObject({ fault: null, value });
  });

  test("that comes twice counts once", () => {
    const { lines } = opened(fileOf('{"name": "k_roll", "value": 1}, {"name": "k_roll", "value": 3}'));
    expect(lines.map(({ fault }) => fault)).toEqual([null, "twice"]);
    expect(lines[1]).toMatchObject({ value: null });
  });
});

test("the parameters that a file does not name are told", () => {
  expect(opened(fileOf('{"name": "k_roll", "value": 1}')).missing).toHaveLength(16);
});

describe("a file is refused as a whole", () => {
  test.each([
    ["not JSON at all", "k_roll = 2", "not_json"],
    ["cut off", fileOf('{"name": "k_roll"').slice(0, -4), "not_json"],
    ["empty", "", "not_json"],
    ["a list", "[1, 2]", "not_parameters"],
    ["of another program", '{"format": "other", "version": 1, "parameters": []}', "not_parameters"],
    ["without lines", '{"format": "epf-gcs-parameters", "version": 1}', "not_parameters"],
    ["of a newer station", '{"format": "epf-gcs-parameters", "version": 2, "parameters": []}', "newer"],
  ])("when it is %s", (_, text, refusal) => {
    expect(readParameterFile(text, PARAMETERS)).toBe(refusal);
  });
});

test("the words NaN and Infinity within a text stay as they are", () => {
  const file = opened(fileOf("", '"saved": "NaN \\" Infinity",'));
  expect(file.saved).toBe('NaN " Infinity');
});
