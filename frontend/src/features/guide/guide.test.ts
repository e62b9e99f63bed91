import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";
import { SCHEMAS } from "../../test/schemas.gen";
import { type Block, readChapters, readInline } from "./markdown";

const LANGUAGES = ["es", "en"] as const;

const guide = Object.fromEntries(
  LANGUAGES.map((language) => [
    language,
    readChapters(readFileSync(join(import.meta.dirname, `${language}.md`), "utf8")),
  ]),
);

function kinds(language: string): string[][] {
  return (guide[language] ?? []).map(({ blocks }) =>
    blocks.map((block) => {
      const size = block.kind === "table" ? block.rows.length : "items" in block ? block.items.length : 1;
      return `${block.kind} ${block.kind === "picture" ? block.name : size}`;
    }),
  );
}

describe("the guide", () => {
  test("has the same chapters, lists, tables and pictures in both languages", () => {
    expect(kinds("en")).toEqual(kinds("es"));
    expect(kinds("es").length).toBeGreaterThan(7);
  });

  test.each(LANGUAGES)("has each of its pictures with it, in %s", (language) => {
    const pictures = (guide[language] ?? []).flatMap(({ blocks }) =>
      blocks.flatMap((block: Block) => (block.kind === "picture" ? [block.name] : [])),
    );
    const missing = pictures.filter(
      (name) => !existsSync(join(import.meta.dirname, `../../../public/guide/${language}/${name}.webp`)),
    );
    expect(pictures.length).toBeGreaterThan(4);
    expect(missing).toEqual([]);
  });

  test.each(LANGUAGES)("tells of each alarm of the gateway and of the page, in %s", (language) => {
    const { alarmName }: { alarmName: Readonly<Record<string, string>> } = JSON.parse(
      readFileSync(join(import.meta.dirname, `../alarms/alarms.${language}.json`), "utf8"),
    );
    const told = (guide[language] ?? []).flatMap(({ blocks }) =>
      blocks.flatMap((block: Block) =>
        block.kind === "table" ? block.rows.map(([name]) => name?.[0]?.text.toLowerCase()) : [],
      ),
    );
    const ofGateway = SCHEMAS["AlarmState"]?.properties?.["id"]?.enum?.map(String) ?? [];
    expect(ofGateway.length).toBeGreaterThan(10);
    const all = new Set([...ofGateway, ...Object.keys(alarmName)]);
    expect([...all].filter((id) => !told.includes(alarmName[id]?.toLowerCase()))).toEqual([]);
  });

  test.each(LANGUAGES)("leaves no mark of its notation to the reader, in %s", (language) => {
    const text = JSON.stringify(guide[language]);
    expect(text).not.toMatch(/\*\*|`|!\[|\]\(|"\|/);
  });
});

describe("its notation", () => {
  test("knows chapters, headings, paragraphs, lists, steps, tables and pictures", () => {
    const text =
      "before\n\n## One\n\nText.\n\n### Head\n\n- a\n- b\n\n1. c\n\n| h | i |\n|---|---|\n| j | k |\n\n![p](shot)\n\n## Two\n";
    expect(readChapters(text)).toEqual([
      {
        title: "One",
        blocks: [
          { kind: "paragraph", text: [{ kind: "text", text: "Text." }] },
          { kind: "heading", text: "Head" },
          { kind: "list", items: [[{ kind: "text", text: "a" }], [{ kind: "text", text: "b" }]] },
          { kind: "steps", items: [[{ kind: "text", text: "c" }]] },
          {
            kind: "table",
            head: ["h", "i"],
            rows: [[[{ kind: "text", text: "j" }], [{ kind: "text", text: "k" }]]],
          },
          { kind: "picture", name: "shot", text: "p" },
        ],
      },
      { title: "Two", blocks: [] },
    ]);
  });

  test("knows strong words and code in a line", () => {
    expect(readInline("a **b c** `d` e")).toEqual([
      { kind: "text", text: "a " },
      { kind: "strong", text: "b c" },
      { kind: "text", text: " " },
      { kind: "code", text: "d" },
      { kind: "text", text: " e" },
    ]);
  });
});
