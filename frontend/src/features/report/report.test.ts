import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";
import type { FlightReport } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { shown, withUnit } from "./figures";
import english from "./report.en.json";
import spanish from "./report.es.json";
import { addressedReport, createReports, keepReport, reportPath } from "./reportRequests";

const FLIGHT = "20260131T120000Z";
const OTHER = "20260130T120000Z";

describe.each([
  ["es", spanish],
  ["en", english],
] as const)("the words of the report, in %s", (language, words) => {
  test("define each figure as the guide does", () => {
    const text = readFileSync(join(import.meta.dirname, `../guide/${language}.md`), "utf8");
    const rows = new Map(
      [...text.matchAll(/^\| (.+?) \| (.+?) \|$/gm)].map(([, name, meaning]) => [name, meaning] as const),
    );
    const { figures, definitions }: { figures: Record<string, string>; definitions: Record<string, string> } =
      words.report;
    expect(rows.size).toBeGreaterThan(20);
    for (const [key, name] of Object.entries(figures)) {
      expect([name, rows.get(name)]).toEqual([name, definitions[key]]);
    }
  });
});

describe("an open report", () => {
  function asked() {
    const answers: ((report: FlightReport) => void)[] = [];
    const paths: string[] = [];
    const rest = {
      ask: (_method: string, path: string) => {
        paths.push(path);
        return new Promise((resolve) => answers.push((value) => resolve({ ok: true, value })));
      },
    } as unknown as Gateway;
    return { rest, paths, answers };
  }

  test("keeps what it shows while an earlier flight is set beside it", async () => {
    const { rest, paths, answers } = asked();
    const reports = createReports(rest, () => undefined);
    const [first, second] = [{ flight: FLIGHT }, { flight: FLIGHT, earlier: {} }] as FlightReport[];
    reports.open(FLIGHT);
    answers[0]?.(first as FlightReport);
    await Promise.resolve();
    await Promise.resolve();
    expect(reports.store.getState()).toMatchObject({ report: first, isWorking: false });
    reports.open(FLIGHT, OTHER);
    expect(reports.store.getState()).toMatchObject({ report: first, isWorking: true, compare: OTHER });
    answers[1]?.(second as FlightReport);
    await Promise.resolve();
    await Promise.resolve();
    expect(reports.store.getState()?.report).toBe(second);
    expect(paths[1]).toBe(`/api/v1/flights/${FLIGHT}/report?compare=${OTHER}`);
  });

  test("is not replaced by the late answer of one that was closed", async () => {
    const { rest, answers } = asked();
    const reports = createReports(rest, () => undefined);
    reports.open(FLIGHT);
    reports.close();
    answers[0]?.({ flight: FLIGHT } as FlightReport);
    await Promise.resolve();
    await Promise.resolve();
    expect(reports.store.getState()).toBeNull();
  });

  test("stands in the page's address, and is read from it", () => {
    let address = "http://station/?at=3";
    const line = {
      read: () => address,
      replace: (next: string) => {
        address = next;
      },
    };
    keepReport(line, FLIGHT, OTHER);
    expect(addressedReport(address)).toEqual({ flight: FLIGHT, compare: OTHER });
    keepReport(line, null, null);
    expect(address).toBe("http://station/?at=3");
    expect(addressedReport("http://station/?report=../../etc")).toBeNull();
  });

  test("has a page of its own in the chosen language", () => {
    expect(reportPath(FLIGHT, null, "en")).toBe(`/api/v1/flights/${FLIGHT}/report?format=html&lang=en`);
  });
});

test("what is not known is a dash, and nothing is minus nought", () => {
  expect([shown(null, 1, "s"), shown(-0.01, 1, "s"), withUnit(-2.138, "kt")]).toEqual([
    "—",
    "0.0 s",
    "-2.14 kt",
  ]);
});
