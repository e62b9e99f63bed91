import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { subjectRows } from "./roleTable";

const row = { path: "/x", tag: "x" };

test("a subject says who sees it and every different way to change it, the least role first", () => {
  expect(
    subjectRows([
      { ...row, method: "GET", least: "viewer", control: false },
      { ...row, method: "DELETE", least: "owner", control: true },
      { ...row, method: "PUT", least: "operator", control: true },
      { ...row, method: "PATCH", least: "operator", control: true },
      { ...row, method: "POST", least: "operator", control: false },
    ]),
  ).toEqual([
    {
      subject: "x",
      sees: "viewer",
      changes: [
        { least: "operator", control: false },
        { least: "operator", control: true },
        { least: "owner", control: true },
      ],
    },
  ]);
});

test.each(["es", "en"])("each subject of the interface has a name for people (%s)", (language) => {
  const { roleSubject } = JSON.parse(
    readFileSync(join(import.meta.dirname, `guide.${language}.json`), "utf8"),
  ) as {
    roleSubject: Readonly<Record<string, string>>;
  };
  expect(subjectRows().map(({ subject }) => subject)).toEqual(Object.keys(roleSubject).sort());
});
