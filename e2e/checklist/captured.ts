import { readFileSync } from "node:fs";
import { ROOT } from "../support/processes.js";

interface Captured {
  readonly action: string;
  readonly value?: number | string;
  readonly hex: string;
}

const captured: readonly Captured[] = readFileSync(`${ROOT}/protocol/vectors/commands.jsonl`, "utf8")
  .trim()
  .split("\n")
  .map((line) => JSON.parse(line));

/** The bytes that the captured station sent for a control of its own, in hexadecimal; empty where it sent none. */
export function bytesOf(action: string, value?: number | string): string {
  const found = captured.find((entry) => entry.action === action && (value === undefined || entry.value === value));
  if (found === undefined) throw new Error(`nothing was captured for ${action} ${value ?? ""}`);
  return found.hex;
}
