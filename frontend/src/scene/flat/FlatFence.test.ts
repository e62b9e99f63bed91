import { expect, test } from "vitest";
import { WARNED } from "../colours";
import { FlatFence } from "./FlatFence";
import { type FlatView, fromScreen } from "./projection";
import { Words } from "./Words";

const VIEW: FlatView = {
  centre: { latitude_deg: 28, longitude_deg: -15.4 },
  zoom: 12,
  width_px: 600,
  height_px: 400,
};
const at = (x: number, y: number) => fromScreen(VIEW, { x, y });
const SQUARE = [at(100, 100), at(300, 100), at(300, 300), at(100, 300)];

/** The lines that were drawn in the colour of a warning, by their ends in whole pixels. */
function warned(fence: FlatFence): readonly string[] {
  const lines: string[] = [];
  let line: string[] = [];
  const context = new Proxy({} as CanvasRenderingContext2D, {
    get: (state, name: keyof CanvasRenderingContext2D) => {
      const point = (x: number, y: number): void => void line.push(`${Math.round(x)},${Math.round(y)}`);
      const calls: Readonly<Record<string, unknown>> = {
        beginPath: () => {
          line = [];
        },
        moveTo: point,
        lineTo: point,
        stroke: () => state.strokeStyle === WARNED && lines.push(line.join(" ")),
      };
      return calls[name] ?? state[name] ?? (() => undefined);
    },
  });
  fence.draw(context, VIEW, new Words());
  return lines;
}

test("the two sides that cross are marked, also while a corner is being dragged", () => {
  const fence = new FlatFence(() => undefined);
  fence.listen(() => undefined);
  fence.show(SQUARE, true);
  expect(warned(fence)).toEqual([]);
  const drag = fence.find(() => VIEW, { x: 100, y: 100 }, 10)?.drag?.({ x: 100, y: 100 }, false);
  drag?.move({ x: 400, y: 200 }, false);
  expect(warned(fence)).toEqual(["300,100 300,300", "100,300 400,200"]);
  drag?.cancel();
  expect(warned(fence)).toEqual([]);
  fence.show([at(100, 100), at(300, 300), at(300, 100), at(100, 300)], false);
  expect(warned(fence)).toEqual(["100,100 300,300", "300,100 100,300"]);
});
