import { fireEvent, render, screen } from "@testing-library/react";
import { createRef } from "react";
import { expect, test, vi } from "vitest";
import { destination } from "../../lib/geodesy";
import type { Waypoint } from "../../lib/plan";
import { PlanSketch, type PlanSketchHandle } from "./PlanSketch";

const first: Waypoint = { latitude_deg: 27.9319, longitude_deg: -15.3866, altitude_ft: 1000, speed_kt: 55 };
const plan: readonly Waypoint[] = [
  first,
  { ...first, ...destination(first, 0, 5000) },
  { ...first, ...destination(first, 90, 5000), speed_kt: 100 },
];

function draw(active: number | null = null) {
  const handle = createRef<PlanSketchHandle>();
  const onSelect = vi.fn();
  const { container } = render(
    <PlanSketch
      ref={handle}
      label="Plan"
      waypoints={plan}
      active={active}
      selected={0}
      onSelect={onSelect}
      aircraft={null}
      north="N"
      formatLength={(length_m) => `${length_m} m`}
    />,
  );
  const all = (selector: string) => [...container.querySelectorAll<SVGElement>(selector)];
  return { handle, onSelect, all };
}

test("draws every point, the legs between them and a capture circle that grows with the speed", () => {
  const { all } = draw();
  expect(screen.getByRole("img", { name: "Plan" })).toBeDefined();
  expect(all(".plan-sketch-point")).toHaveLength(3);
  expect(all(".plan-sketch-leg")).toHaveLength(2);
  const [slow, , fast] = all(".plan-sketch-capture").map((circle) => Number(circle.getAttribute("r")));
  expect((fast ?? 0) / (slow ?? 1)).toBeCloseTo(701 / 200, 1);
});

test("marks the point that is flown to and the leg to it, and none where that is not known", () => {
  const { all } = draw(2);
  expect(all(".plan-sketch-leg").map((leg) => leg.dataset["active"])).toEqual(["false", "true"]);
  expect(all(".plan-sketch-point").map((point) => point.dataset["active"])).toEqual([
    "false",
    "false",
    "true",
  ]);
});

test("marks nothing where it is not known what is flown to", () => {
  const { all } = draw(null);
  expect(all('[data-active="true"]')).toEqual([]);
});

test("draws the aircraft where it is while that is live, and not at all when it is not", () => {
  const { handle, all } = draw();
  const [mark] = all(".plan-sketch-aircraft");
  expect(mark?.dataset["state"]).toBe("none");
  handle.current?.paintAircraft(first, 90);
  expect(mark?.dataset["state"]).toBe("live");
  expect(mark?.getAttribute("transform")).toContain("rotate(90)");
  handle.current?.paintAircraft(first, null);
  expect(mark?.dataset["heading"]).toBe("none");
  handle.current?.paintAircraft(null, null);
  expect(mark?.dataset["state"]).toBe("none");
});

test("a press on a point selects it", () => {
  const { onSelect, all } = draw();
  const second = all(".plan-sketch-point")[1];
  if (second === undefined) throw new Error("no second point");
  fireEvent.pointerDown(second);
  expect(onSelect.mock.calls).toEqual([[1]]);
});
