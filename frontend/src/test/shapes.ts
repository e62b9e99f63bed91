import type { Schema } from "../../scripts/guards.ts";
import type { Checked } from "../lib/check";
import type { StreamEvent } from "../protocol/envelope";
import type * as guards from "../protocol/guards.gen";
import { SCHEMAS } from "./schemas.gen";

type Guards = typeof guards;
type ShapeName = { [K in keyof Guards]: K extends `is${infer N}` ? N : never }[keyof Guards];
type Shape<N extends ShapeName> = Checked<Guards[`is${N}`]>;

/**
 * A value as the gateway's description has it, with some parts changed: null where that is allowed, else the first
 * word, 0, false, and nothing in it.
 */
export function aShape<N extends ShapeName>(name: N, parts: Partial<Shape<N>> = {}): Shape<N> {
  return { ...(blank({ $ref: name }) as object), ...parts } as Shape<N>;
}

/** An event of the stream at this Unix time. */
export function anEvent<N extends NonNullable<StreamEvent["event"]>>(
  event: N,
  data: Extract<StreamEvent, { event: N }>["data"],
  t_s = 1,
): Extract<StreamEvent, { event: N }> {
  return { type: "event", event, t_s, data } as Extract<StreamEvent, { event: N }>;
}

function blank({ $ref, anyOf, type, enum: words, const: only, properties }: Schema): unknown {
  if ($ref !== undefined) {
    const named = SCHEMAS[$ref.split("/").at(-1) ?? ""];
    if (named === undefined) {
      throw new Error(`the description has no ${$ref}`);
    }
    return blank(named);
  }
  if (anyOf !== undefined) {
    return anyOf.some((one) => one.type === "null") ? null : blank(anyOf[0] ?? {});
  }
  if (properties !== undefined) {
    return Object.fromEntries(Object.entries(properties).map(([name, part]) => [name, blank(part)]));
  }
  return only ?? words?.[0] ?? BLANKS[type ?? ""]?.();
}

const BLANKS: Readonly<Record<string, () => unknown>> = {
  string: () => "",
  number: () => 0,
  integer: () => 0,
  boolean: () => false,
  array: () => [],
  object: () => ({}),
};
