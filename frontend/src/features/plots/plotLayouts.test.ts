import { expect, test } from "vitest";
import { MOST_PANES, withPlotOf } from "./plotLayouts";

test("a signal that is plotted is found where it is, another one gets a plot of its own above the others", () => {
  const panes = [["ahrs.roll_deg"], ["analog.battery_v", "gps.satellites"]];
  expect(withPlotOf(panes, "gps.satellites")).toEqual({ panes, pane: 1 });
  expect(withPlotOf(panes, "gps.speed_kt")).toEqual({ panes: [["gps.speed_kt"], ...panes], pane: 0 });
});

test("where every plot is taken the last one gives way", () => {
  const panes = Array.from({ length: MOST_PANES }, (_, nth) => [`ahrs.${nth}`]);
  const { panes: next } = withPlotOf(panes, "gps.speed_kt");
  expect(next).toHaveLength(MOST_PANES);
  expect(next[0]).toEqual(["gps.speed_kt"]);
});
