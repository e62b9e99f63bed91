import { describe, expect, test } from "vitest";
import type { Vector } from "./attitude";
import { fitField } from "./ellipsoid";
import { FieldSamples, fitText, MOST_SAMPLES, samplesCsv } from "./fieldSamples";
import { DIRECTIONS } from "./sphereCover";

describe("the collection", () => {
  test("keeps one reading of a board that lies still", () => {
    const samples = new FieldSamples();
    for (let index = 0; index < 500; index += 1) {
      samples.add([0.6 + 0.0001 * index, 0.1, -0.7]);
    }
    expect(samples.points).toHaveLength(1);
  });

  test("keeps what lies apart, and no more than its room", () => {
    const samples = new FieldSamples();
    for (let index = 0; index < 3 * MOST_SAMPLES; index += 1) {
      samples.add([index, 0, 0]);
    }
    expect(samples.points).toHaveLength(MOST_SAMPLES);
  });

  test("takes nothing that is no number", () => {
    const samples = new FieldSamples();
    expect(samples.add([Number.NaN, 0, 0])).toBe(false);
    expect(samples.points).toEqual([]);
  });

  test("gives back what was cleared until something new is collected", () => {
    const samples = new FieldSamples();
    samples.add([1, 0, 0]);
    samples.clear();
    expect(samples.points).toEqual([]);
    samples.restore();
    expect(samples.points).toEqual([[1, 0, 0]]);
    samples.clear();
    samples.add([0, 1, 0]);
    expect(samples.canRestore).toBe(false);
    samples.restore();
    expect(samples.points).toEqual([[0, 1, 0]]);
  });
});

describe("the calibration as text", () => {
  const points = DIRECTIONS.map(([x, y, z]): Vector => [2 * x + 0.25, 2 * y - 0.5, 2 * z]);
  const fit = fitField(points);

  test("has offset, scale, soft iron, field and residual with their names", () => {
    expect(fit.kind).toBe("ellipsoid");
    const text = fit.kind === "refused" ? "" : fitText(fit);
    expect(text).toContain("offset = [0.25000, -0.50000, ");
    expect(text).toContain("scale = [1.00000, 1.00000, 1.00000]");
    expect(text).toMatch(/^soft_iron = \[\[1\.00000, -?0\.00000, -?0\.00000\], \[/m);
    expect(text).toContain("field = 2.00000");
    expect(text).toContain("residual_rms = 0.00000");
  });

  test("has each reading with what becomes of it", () => {
    const lines = samplesCsv(points, fit.kind === "refused" ? null : fit).split("\r\n");
    expect(lines).toHaveLength(points.length + 2);
    const [x, y, z, a, b, c] = (lines[1] ?? "").split(",").map(Number);
    expect([x, y, z]).toEqual(points[0]?.map((value) => expect.closeTo(value, 4)));
    expect(Math.hypot(a ?? 0, b ?? 0, c ?? 0)).toBeCloseTo(2, 3);
    expect(samplesCsv(points, null).split("\r\n")[1]).toMatch(/,,,$/);
  });
});
