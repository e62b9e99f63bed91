import { expect, test } from "vitest";
import { installCanvas } from "../test/canvas";

// uPlot asks for the display's density when it is loaded.
installCanvas();
const { unitAxes } = await import("./drawnPlot");

test("each axis has a label beside its numbers: the unit of one cannot be taken for that of its neighbour", () => {
  const look = { colour: () => "black", fontSize_px: 12, fontFamily: "mono" };
  const axes = unitAxes(["°", "°/s", ""], look, "Aileron");
  expect(axes.map(({ label, side }) => [label, side])).toEqual([
    ["°", 3],
    ["°/s", 1],
    ["Aileron", 3],
  ]);
});
