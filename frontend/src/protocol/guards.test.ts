import { describe, expect, test } from "vitest";
import { EXCEPTIONS, type Schema } from "../../scripts/guards.ts";
import { type Check, faultIn } from "../lib/check";
import { SCHEMAS } from "../test/schemas.gen";
import * as guards from "./guards.gen";
import { PARAMETERS } from "./messages.gen";

const checks = guards as unknown as Readonly<Record<string, Check<unknown>>>;
const names = Object.keys(SCHEMAS).filter((name) => name !== "Problem");

/** A schema of the document with the exceptions of the page applied. */
function schemaOf(name: string): Schema {
  const { properties = {}, required = [], ...rest } = SCHEMAS[name] ?? {};
  const entries = Object.entries(properties).map(([property, part]) => {
    const place = `${name}.${property}`;
    if (EXCEPTIONS.parameterNames.includes(place)) {
      return [property, { type: "string", enum: PARAMETERS.map((parameter) => parameter.name) }] as const;
    }
    return [property, EXCEPTIONS.openWords.includes(place) ? opened(part) : part] as const;
  });
  return {
    ...rest,
    properties: Object.fromEntries(entries),
    required: required.filter((property) => !EXCEPTIONS.optional.includes(`${name}.${property}`)),
  };
}

function opened({ enum: _, ...schema }: Schema): Schema {
  return schema.anyOf ? { anyOf: schema.anyOf.map(opened) } : schema;
}

/** The schema that a reference names; any other schema as it is. */
function resolved(schema: Schema): Schema {
  return schema.$ref === undefined ? schema : schemaOf(schema.$ref.split("/").at(-1) ?? "");
}

/** Valid values of a schema; together they contain every alternative and every word. */
function samples(schema: Schema): unknown[] {
  const { anyOf, type, items, properties, additionalProperties, enum: words } = resolved(schema);
  if (anyOf) return anyOf.flatMap(samples);
  if (words) return [...words];
  if (items) return [...samples(items).map((entry) => [entry, entry]), []];
  if (properties) {
    const parts = Object.entries(properties).map(([name, part]) => [name, samples(part)] as const);
    const first = Object.fromEntries(parts.map(([name, [value]]) => [name, value]));
    const others = parts.flatMap(([name, [, ...values]]) =>
      values.map((value) => ({ ...first, [name]: value })),
    );
    return [first, ...others];
  }
  if (typeof additionalProperties === "object") {
    return [...samples(additionalProperties).map((one) => ({ one })), {}];
  }
  return [{ string: "a text", number: 1.5, integer: 2, boolean: true, null: null, object: {} }[type ?? ""]];
}

function sample(schema: Schema): unknown {
  return samples(schema)[0];
}

const STRANGERS = ["a word that nobody agreed on", 7, true, null, [["x"]], { one: { two: null } }];

/** Whether a schema allows one of the strangers. */
function allows(schema: Schema, value: unknown): boolean {
  const { anyOf, type, items, properties, additionalProperties, enum: words } = resolved(schema);
  if (anyOf) return anyOf.some((one) => allows(one, value));
  if (words) return words.includes(value);
  if (Array.isArray(value)) return items !== undefined && value.every((entry) => allows(items, entry));
  if (typeof value === "object" && value !== null) {
    const isOpen = type === "object" && properties === undefined;
    return typeof additionalProperties === "object" && isOpen
      ? Object.values(value).every((entry) => allows(additionalProperties, entry))
      : isOpen;
  }
  const kind = value === null ? "null" : typeof value;
  return kind === (type === "integer" ? "number" : type);
}

type Fault = readonly [path: string, value: unknown];

/** Values with one fault each, and the path at which a guard must find it. */
function faulty(schema: Schema): Fault[] {
  const { anyOf, items, properties, additionalProperties, required = [] } = resolved(schema);
  const strangers = STRANGERS.filter((value) => !allows(schema, value)).map((value): Fault => ["", value]);
  if (anyOf?.length === 2 && anyOf[0] && anyOf[1]?.type === "null") {
    return faulty(anyOf[0]).filter(([path, value]) => path !== "" || value !== null);
  }
  if (items) {
    const entries = faulty(items).map(([path, value]): Fault => [`[1]${path}`, [sample(items), value]]);
    return [...strangers.filter(([, value]) => !Array.isArray(value)), ...entries];
  }
  const others = strangers.filter(([, value]) => !isRecord(value));
  if (properties) {
    const good = sample(schema) as Readonly<Record<string, unknown>>;
    const missing = required.map((name): Fault => [`.${name}`, without(good, name)]);
    const parts = Object.entries(properties).flatMap(([name, part]) =>
      faulty(part).map(([path, value]): Fault => [`.${name}${path}`, { ...good, [name]: value }]),
    );
    return [...others, ...missing, ...parts];
  }
  if (typeof additionalProperties === "object") {
    const entries = faulty(additionalProperties).map(([path, value]): Fault => [`.b${path}`, { b: value }]);
    return [...others, ...entries];
  }
  return strangers;
}

function without(value: object, name: string): object {
  return Object.fromEntries(Object.entries(value).filter(([key]) => key !== name));
}

function isRecord(value: unknown): boolean {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

test("every schema that the gateway answers with has a guard", () => {
  expect(names.length).toBeGreaterThan(40);
  expect(names.filter((name) => checks[`is${name}`] === undefined)).toEqual([]);
});

describe.each(names)("the guard of %s", (name) => {
  const check = checks[`is${name}`] as Check<unknown>;
  const good = sample(schemaOf(name)) as object;

  test("takes all that is as described, with fields of a newer gateway too", () => {
    expect(samples(schemaOf(name)).filter((value) => !check(value))).toEqual([]);
    expect(faultIn(check, { ...good, added_later: { any: "thing" } })).toBeNull();
  });

  test("refuses what misses a field or has a wrong type anywhere, and says where", () => {
    const schema = schemaOf(name);
    const all = faulty(schema);
    // An event that only says that something has changed has no field to miss.
    const hasFields = Object.keys(schema.properties ?? {}).length > 0;
    expect(all.length).toBeGreaterThan(hasFields ? STRANGERS.length : 0);
    const wronglyTaken = all.filter(([path, value]) => check(value) || faultIn(check, value) !== path);
    expect(wronglyTaken).toEqual([]);
  });
});

test("every event of the stream is checked by the guard of a schema", () => {
  const guarded = new Set<unknown>(names.map((name) => checks[`is${name}`]));
  expect(Object.entries(guards.EVENT_CHECKS).filter(([, check]) => !guarded.has(check))).toEqual([]);
  expect(Object.keys(guards.EVENT_CHECKS).length).toBeGreaterThan(20);
});

test.each(EXCEPTIONS.openWords)("%s may be a word that this page does not know", (place) => {
  const [name = "", property = ""] = place.split(".");
  const good = sample(schemaOf(name)) as object;
  expect(faultIn(checks[`is${name}`] as Check<unknown>, { ...good, [property]: "added_later" })).toBeNull();
});

test.each(EXCEPTIONS.optional)("%s may be missing", (place) => {
  const [name = "", property = ""] = place.split(".");
  const rest = without(sample(schemaOf(name)) as object, property);
  expect(faultIn(checks[`is${name}`] as Check<unknown>, rest)).toBeNull();
});
