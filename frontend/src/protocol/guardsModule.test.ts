import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, describe, expect, test } from "vitest";
import { type ApiDocument, guardsModule, type Schema, type Schemas } from "../../scripts/guards.ts";
import { SCHEMAS } from "../test/schemas.gen";
import { ACCESS_TABLE } from "./access.gen";
import * as guards from "./guards.gen";

const NO_EXCEPTIONS = { openWords: [], optional: [], parameterNames: [] };
const reference = (name: string): Schema => ({ $ref: `#/components/schemas/${name}` });

/** A document of these schemas, the named ones as answers. */
function documentOf(schemas: Schemas, answers = Object.keys(schemas)): ApiDocument {
  const operation = (name: string) => ({
    responses: { 200: { content: { "application/json": { schema: reference(name) } } } },
  });
  return {
    paths: Object.fromEntries(answers.map((name) => [`/${name}`, { get: operation(name) }])),
    components: { schemas },
  };
}

const PLANE: Schema = {
  description: "An aircraft.\nWith two lines.",
  type: "object",
  properties: {
    name: { type: "string" },
    kind: { type: "string", enum: ["glider", "jet"] },
    only: { type: "string", const: "this" },
    engines: { type: "integer" },
    span_m: { anyOf: [{ type: "number" }, { type: "null" }] },
    pilot: reference("Pilot"),
    tags: { type: "object", additionalProperties: { anyOf: [{ type: "number" }, { type: "boolean" }] } },
    extra: { type: "object" },
    note: { type: "string" },
  },
  required: ["name", "kind", "only", "engines", "span_m", "pilot", "tags", "extra"],
};
const PILOT: Schema = { type: "object", properties: { name: { type: "string" } }, required: ["name"] };
const OTHER: Schema = { type: "object", properties: {} };

describe("the module", () => {
  test("has a guard for each answer and for its parts, which come first", () => {
    const document = documentOf({ Plane: PLANE, Pilot: PILOT, Other: OTHER }, ["Plane"]);
    const [head, ...rest] = guardsModule(document, NO_EXCEPTIONS).split("\n\n");
    expect(head).toContain("Do not edit.");
    expect(rest.join("\n\n")).toBe(`export const isPilot = shape({
  name: isText,
});
export type Pilot = Checked<typeof isPilot>;

/** An aircraft.
 * With two lines. */
export const isPlane = shape({
  name: isText,
  kind: oneOf("glider", "jet"),
  only: oneOf("this"),
  engines: isNumber,
  span_m: nullable(isNumber),
  pilot: isPilot,
  tags: dictionary(either(isNumber, isFlag)),
  extra: isObject,
  note: optional(isText),
});
export type Plane = Checked<typeof isPlane>;
`);
  });

  test("has a guard for what comes on the stream and is no answer", () => {
    const document = { ...documentOf({ Pilot: PILOT }, []), "x-shapes": { Pilot: reference("Pilot") } };
    expect(guardsModule(document, NO_EXCEPTIONS)).toContain("export const isPilot = shape(");
  });

  test("has the guards of the data of all events, in a table by the events' names", () => {
    const document = {
      ...documentOf({ Pilot: PILOT, Other: OTHER }, []),
      "x-events": { pilot_changed: reference("Pilot"), nothing: reference("Other") },
    };
    const text = guardsModule(document, NO_EXCEPTIONS);
    expect(text).toContain("export const isOther = shape({});\n");
    expect(text).toContain(
      "export const EVENT_CHECKS = {\n  nothing: isOther,\n  pilot_changed: isPilot,\n};\n",
    );
  });

  test("imports what it uses", () => {
    const [head] = guardsModule(documentOf({ Pilot: PILOT }), NO_EXCEPTIONS).split("\n\n");
    expect(head).toContain('import { type Checked, isText, shape } from "../lib/check";');
  });

  test("takes any text where words are open, and what is excepted may be missing", () => {
    const text = guardsModule(documentOf({ Plane: PLANE, Pilot: PILOT }), {
      openWords: ["Plane.kind"],
      optional: ["Plane.pilot"],
      parameterNames: ["Pilot.name"],
    });
    expect(text).toContain("  kind: isText,\n");
    expect(text).toContain("  pilot: optional(isPilot),\n");
    expect(text).toContain("  name: isParameterName,\n");
  });

  test.each([
    ["a kind of schema that it does not know", { properties: { a: { type: "tuple" } } }, "Odd.a"],
    ["words that are no text", { properties: { a: { type: "integer", enum: [1, 2] } } }, "Odd.a"],
    ["a reference to nothing", { properties: { a: reference("Gone") } }, "Odd → Gone"],
    ["a schema that holds itself", { properties: { a: reference("Odd") } }, "Odd → Odd"],
    ["an answer that is no object", { type: "string" }, "Odd"],
  ])("is not made of %s", (_, schema, place) => {
    expect(() => guardsModule(documentOf({ Odd: schema }), NO_EXCEPTIONS)).toThrow(place);
  });

  test("is not made with an exception for what is not there", () => {
    const exceptions = { ...NO_EXCEPTIONS, optional: ["Pilot.age"] };
    expect(() => guardsModule(documentOf({ Pilot: PILOT }), exceptions)).toThrow("Pilot.age");
  });
});

/** The routes of which the committed table of access was made. */
const ROUTES: Record<string, Record<string, object>> = {};
for (const { path, method, tag, least, control } of ACCESS_TABLE) {
  const address = `/api/v1${path}`;
  const operations = ROUTES[address] ?? {};
  ROUTES[address] = operations;
  operations[method.toLowerCase()] = {
    responses: {},
    tags: [tag],
    "x-least-role": least,
    "x-needs-control": control,
  };
}

/** The events of which the committed guards were made. */
const SCHEMA_OF = new Map<unknown, string>(
  Object.entries(guards).map(([name, check]) => [check, name.slice("is".length)]),
);
const EVENTS = Object.fromEntries(
  Object.entries(guards.EVENT_CHECKS).map(([event, check]) => [event, reference(SCHEMA_OF.get(check) ?? "")]),
);

describe("the check of what was generated", () => {
  const folder = mkdtempSync(join(tmpdir(), "guards-"));
  afterAll(() => rmSync(folder, { recursive: true, force: true }));

  function check(schemas: Schemas) {
    const file = join(folder, "openapi.json");
    const answers = Object.keys(schemas).filter((name) => name !== "Problem");
    const shapes = Object.fromEntries(answers.map((name) => [name, reference(name)]));
    const document = { paths: ROUTES, components: { schemas }, "x-shapes": shapes, "x-events": EVENTS };
    writeFileSync(file, JSON.stringify(document));
    const script = join(import.meta.dirname, "../../scripts/generate-api.mjs");
    const { status, stderr } = spawnSync(process.execPath, [script, "--check", file], { encoding: "utf8" });
    return { status, stderr };
  }

  test("agrees with the description of which the committed files were made", () => {
    expect(check(SCHEMAS)).toEqual({ status: 0, stderr: "" });
  });

  test.each([
    ["of another type", { can_restore: { type: "string" } }],
    ["more", { can_restore: { type: "boolean" }, added_later: { type: "boolean" } }],
    ["less", {}],
  ])("fails where the description has a field %s", (_, changed) => {
    const { can_restore: __, ...rest } = SCHEMAS["TrackState"]?.properties ?? {};
    const properties = { ...rest, ...changed };
    const { status, stderr } = check({ ...SCHEMAS, TrackState: { ...SCHEMAS["TrackState"], properties } });
    expect(status).toBe(1);
    expect(stderr).toContain("src/protocol/guards.gen.ts is out of date");
  });
});
