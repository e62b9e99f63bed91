import { isNumber, isObject, isText } from "../../lib/check";
import { type OtherLine, readOtherParameters } from "./otherParameters";
import type { GainInfo } from "./parameterValues";

const FORMAT = "epf-gcs-parameters";
const VERSION = 1;

export interface BoardFirmware {
  readonly name: string | null;
  readonly version: string | null;
}

export type ParameterFault = "no_name" | "unknown" | "not_a_number" | "out_of_range" | "not_whole" | "twice";

/** One line of a parameter file; a valid one has its `parameter`. */
export type FileLine =
  | { readonly name: string; readonly text: string; readonly fault: ParameterFault; readonly parameter: null }
  | {
      readonly name: string;
      readonly text: string;
      readonly fault: ParameterFault | null;
      readonly parameter: GainInfo;
      readonly value: number | null;
    };

export interface ParameterFile {
  /** When it was saved, as stated in the file. */
  readonly saved: string | null;
  readonly board: BoardFirmware | null;
  readonly lines: readonly FileLine[];
  /** The parameters that it lacks. */
  readonly missing: readonly string[];
  /** Parameters of another autopilot, which do not exist here. */
  readonly leftOut: readonly string[];
}

/** Why the whole file cannot be read. */
export type FileRefusal = "not_json" | "not_parameters" | "newer" | "nothing_here";

/** The text of a file with these values by name: a line each, in their order. */
export function writeParameterFile(
  values: ReadonlyMap<string, number>,
  board: BoardFirmware | null,
  saved: Date,
): string {
  const file = {
    format: FORMAT,
    version: VERSION,
    saved: saved.toISOString(),
    board,
    parameters: [...values].map(([name, value]) => ({ name, value })),
  };
  return `${JSON.stringify(file, null, 2)}\n`;
}

/** The lines of a file, each with its fault if any; or why it is not a parameter file. `gains`: what the board has. */
export function readParameterFile(text: string, gains: readonly GainInfo[]): ParameterFile | FileRefusal {
  const file = parse(text);
  if (file === undefined) {
    const others = readOtherParameters(text);
    return others === null ? "not_json" : readOthers(others, gains);
  }
  if (!(isObject(file) && file["format"] === FORMAT && Array.isArray(file["parameters"]))) {
    return "not_parameters";
  }
  if (file["version"] !== VERSION) {
    return "newer";
  }
  const seen = new Set<string>();
  const lines = file["parameters"].map((entry: unknown) => readLine(entry, seen, gains));
  const { saved, board } = file;
  return {
    saved: isText(saved) ? saved : null,
    board: isObject(board) ? { name: textOf(board["name"]), version: textOf(board["version"]) } : null,
    lines,
    missing: missingOf(seen, gains),
    leftOut: [],
  };
}

/**
 * Gains by their own names; a parameter of another autopilot is none of them, however alike its name sounds: its unit
 * and its law are others.
 */
function readOthers(others: readonly OtherLine[], gains: readonly GainInfo[]): ParameterFile | FileRefusal {
  const isKnown = (line: OtherLine): boolean => gains.some(({ name }) => name === line.name);
  const seen = new Set<string>();
  const lines = others
    .filter(isKnown)
    .map(({ name, text }) => readLine({ name, value: numberOf(text) }, seen, gains));
  const leftOut = others.filter((line) => !isKnown(line)).map(({ name }) => name);
  return lines.length === 0
    ? "nothing_here"
    : { saved: null, board: null, lines, missing: missingOf(seen, gains), leftOut };
}

/** The text itself where it is no number, so that its line can be reported. */
function numberOf(text: string): number | string {
  const value = Number(text);
  return Number.isFinite(value) ? value : text;
}

function missingOf(seen: ReadonlySet<string>, gains: readonly GainInfo[]): readonly string[] {
  return gains.map(({ name }) => name).filter((name) => !seen.has(name));
}

function readLine(entry: unknown, seen: Set<string>, gains: readonly GainInfo[]): FileLine {
  const name = isObject(entry) && isText(entry["name"]) ? entry["name"] : null;
  const raw = isObject(entry) ? entry["value"] : entry;
  const text = isText(raw) ? raw : (JSON.stringify(raw) ?? "");
  if (name === null) {
    return { name: "", text, fault: "no_name", parameter: null };
  }
  const parameter = gains.find((known) => known.name === name);
  if (parameter === undefined) {
    return { name, text, fault: "unknown", parameter: null };
  }
  const isTwice = seen.has(name);
  seen.add(name);
  const fault = isTwice ? "twice" : valueFault(parameter, raw);
  const value = fault === null && isNumber(raw) ? raw : null;
  return { name: parameter.name, text, fault, parameter, value };
}

/** Why the board would reject this value; null if it would not. */
export function valueFault(
  { minimum, maximum, isInteger }: GainInfo,
  value: unknown,
): "not_a_number" | "out_of_range" | "not_whole" | null {
  if (!isNumber(value)) {
    return "not_a_number";
  }
  if (value < minimum || value > maximum) {
    return "out_of_range";
  }
  return isInteger && !Number.isInteger(value) ? "not_whole" : null;
}

/** Some programs write NaN and Infinity, which JSON lacks: read as text, so that their lines can be reported. */
const NO_JSON = /"(?:[^"\\]|\\.)*"|-?\b(?:NaN|Infinity)\b/g;

function parse(text: string): unknown {
  try {
    return JSON.parse(text.replace(NO_JSON, (token) => (token.startsWith('"') ? token : `"${token}"`)));
  } catch {
    return undefined;
  }
}

function textOf(value: unknown): string | null {
  return isText(value) ? value : null;
}
