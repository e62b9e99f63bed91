import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { PLOT_DASHES, plotColour } from "./plotColours";
import { axisLook, axisNumber, axisWidth, type Look, lookOf, MOST_AXES, scaleOf, sizeOf } from "./plotLook";

export interface DrawnPlot {
  readonly plot: uPlot;
  readonly destroy: () => void;
}

/** A uPlot that follows the size of its element and the theme: the colours of `options`' look are always today's. */
export function drawnPlot(
  element: HTMLElement,
  options: (look: Look) => Omit<uPlot.Options, "width" | "height">,
  data: uPlot.AlignedData,
): DrawnPlot {
  let look = lookOf(element);
  const { fontSize_px, fontFamily } = look;
  const plot = new uPlot(
    { ...sizeOf(element), ...options({ colour: (name) => look.colour(name), fontSize_px, fontFamily }) },
    data,
    element,
  );
  const resized = new ResizeObserver(() => plot.setSize(sizeOf(element)));
  resized.observe(element);
  const dressed = new MutationObserver(() => {
    look = lookOf(element);
    plot.redraw(false, true);
  });
  dressed.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  return {
    plot,
    destroy: () => {
      resized.disconnect();
      dressed.disconnect();
      plot.destroy();
    },
  };
}

/** Each unit once, in the order of the series. */
export function unitsOf(series: ReadonlyArray<{ readonly unit: string }>): string[] {
  return [...new Set(series.map(({ unit }) => unit))];
}

/** An axis for each unit that there is room for. `noUnit` is the label of the axis without one; it keeps its place. */
export function unitAxes(units: readonly string[], look: Look, noUnit: string): uPlot.Axis[] {
  return units.slice(0, MOST_AXES).map((unit, index) => ({
    ...axisLook(look),
    scale: scaleOf(unit),
    side: index % 2 === 0 ? 3 : 1,
    values: (_, splits, _axis, _space, step) => splits.map((split) => axisNumber(split, step)),
    size: (_, values) => axisWidth(values, look.fontSize_px),
    ...(index === 0 ? {} : { grid: { show: false } }),
    // Each axis has one, so that a label always belongs to the numbers on its inner side.
    label: unit || noUnit || " ",
    labelSize: 1.5 * look.fontSize_px,
    labelGap: 0,
  }));
}

/** Scale, colour and dashes of the line at this place. */
export function lineLook(unit: string, index: number, { colour }: Look) {
  return {
    scale: scaleOf(unit),
    stroke: () => colour(plotColour(index)),
    dash: [...(PLOT_DASHES[index % PLOT_DASHES.length] ?? [])],
  };
}
