import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";
import { COMMANDS } from "../protocol/messages.gen";
import { SCHEMAS } from "../test/schemas.gen";
import { CATALOGUES } from "./catalogues";

const { es, en } = CATALOGUES;

/** Every text of a catalogue by its full key. */
function texts(node: unknown, prefix = ""): Map<string, string> {
  if (typeof node === "string") {
    return new Map([[prefix, node]]);
  }
  const entries = Object.entries(node as Record<string, unknown>);
  return new Map(
    entries.flatMap(([name, child]) => [...texts(child, prefix === "" ? name : `${prefix}.${name}`)]),
  );
}

/** The names in braces, in alphabetical order. */
function values(text: string): string[] {
  return [...text.matchAll(/\{\{(\w+)\}\}/g)].map((match) => match[1] ?? "").sort();
}

const spanish = texts(es);
const english = texts(en);

test("both catalogues have the same keys", () => {
  expect([...english.keys()].sort()).toEqual([...spanish.keys()].sort());
});

test.each(["es", "en"])("no two rooms have words of one name (%s)", (language) => {
  const root = join(import.meta.dirname, "..");
  const names = readdirSync(root, { recursive: true, encoding: "utf8" })
    .filter((file) => file.endsWith(`.${language}.json`))
    .flatMap((file) => Object.keys(JSON.parse(readFileSync(join(root, file), "utf8")) as object));
  expect(names.length).toBeGreaterThan(50);
  expect(names.filter((name, index) => names.indexOf(name) !== index)).toEqual([]);
  expect(names.sort()).toEqual(Object.keys(language === "es" ? es : en).sort());
});

test("no text is empty", () => {
  const empty = [...spanish, ...english].filter(([, text]) => text.trim() === "");
  expect(empty).toEqual([]);
});

test("both say the same values in each sentence", () => {
  const different = [...spanish].filter(
    ([key, text]) => values(text).join() !== values(english.get(key) ?? "").join(),
  );
  expect(different).toEqual([]);
});

test("every command of the board has a name for people", () => {
  const nameless = Object.keys(COMMANDS).filter((name) => !(name in es.command));
  expect(nameless).toEqual([]);
});

test.each([
  ["Problem", "code", es.problem],
  ["AlarmState", "id", es.alarm],
  ["AdviceState", "code", es.advice],
])("each %s of the gateway has a sentence", (schema, field, sentences) => {
  const codes = SCHEMAS[schema]?.properties?.[field]?.enum?.map(String) ?? [];
  expect(codes.length).toBeGreaterThan(5);
  expect(codes.filter((code) => !(code in sentences))).toEqual([]);
});

describe("the source", () => {
  const root = join(import.meta.dirname, "..");
  const files = readdirSync(root, { recursive: true, encoding: "utf8" }).filter(
    (file) => file.endsWith(".tsx") && !file.endsWith(".test.tsx") && !file.startsWith("test/"),
  );
  /** Attributes that a person reads or hears. */
  const spoken =
    /\b(label|title|placeholder|hint|description|unit|alt|aria-[a-z]+)=(["'])(?=[^"']*[A-Za-z]{2})([^"']*)\2/g;
  const machine = /^(true|false|polite|assertive|additions|off|menu|vertical|horizontal)$/;

  test("was found", () => {
    expect(files.length).toBeGreaterThan(30);
  });

  test("holds no text for people outside the catalogues", () => {
    const literal = files.flatMap((file) =>
      [...readFileSync(join(root, file), "utf8").matchAll(spoken)]
        .filter((match) => !machine.test(match[3] ?? ""))
        .map((match) => `${file}: ${match[0]}`),
    );
    expect(literal).toEqual([]);
  });

  test("uses every key of the catalogues", () => {
    const everything = readdirSync(root, { recursive: true, encoding: "utf8" })
      .filter((file) => /\.tsx?$/.test(file) && !/\.(test|gen)\./.test(file))
      .map((file) => readFileSync(join(root, file), "utf8"))
      .join("\n");
    const unused = [...spanish.keys()].filter((key) => {
      // A composed key ends in a value: the source names its beginning.
      const family = key.slice(0, key.indexOf(".") + 1);
      return !(
        // A plural is used without its suffix.
        everything.includes(`"${key.replace(/_(one|other)$/, "")}"`) ||
        everything.includes(`\`${family}\${`) ||
        everything.includes(`@${family}`)
      );
    });
    expect(unused).toEqual([]);
  });
});
