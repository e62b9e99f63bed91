import { type Ref, useEffect, useImperativeHandle, useRef } from "react";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import "./Plot.css";
import { PLOT_DASHES, plotColour } from "./plotColours";
import {
  axisLook,
  axisWidth,
  type Look,
  lookOf,
  MOST_AXES,
  roomy,
  scaleOf,
  sizeOf,
  steady,
} from "./plotLook";

/** Times in seconds relative to now (zero or less), and each series' values; null is a gap. */
export type PlotData = readonly [readonly number[], ...ReadonlyArray<ReadonlyArray<number | null>>];

export interface PlotHandle {
  /** Draw these; the plot always spans from `window_s` before now to now. */
  draw(data: PlotData, marks?: readonly PlotMark[]): void;
}

export interface PlotSeries {
  readonly key: string;
  /** Series of one unit share an axis. */
  readonly unit: string;
  /** The axis spans at least this, and ends at round numbers; the greatest of a unit counts. */
  readonly least_span?: number | undefined;
}

/** A moment to be marked by a line. */
export interface PlotMark {
  /** Relative to now, zero or less. */
  readonly before_s: number;
  readonly label: string;
}

interface Props {
  ref?: Ref<PlotHandle> | undefined;
  series: readonly PlotSeries[];
  window_s: number;
  /** Unit at the time axis. */
  secondsUnit: string;
  /** Called with the index of the row under the pointer; null when it leaves. */
  onPoint?: ((index: number | null) => void) | undefined;
}

/**
 * A plot of series over the last seconds, by uPlot; painted by its handle, without a render. A canvas is silent for
 * screen readers: the user of this component describes it in words.
 */
export function Plot({ ref, series, window_s, secondsUnit, onPoint }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const newest = useRef<PlotData | null>(null);
  const marked = useRef<readonly PlotMark[]>([]);
  const point = useRef(onPoint);
  useEffect(() => {
    point.current = onPoint;
  }, [onPoint]);

  useEffect(() => {
    const element = box.current;
    if (element === null) {
      return;
    }
    let look = lookOf(element);
    const made = new uPlot(
      options({
        series,
        window_s,
        secondsUnit,
        size: sizeOf(element),
        colour: (name) => look.colour(name),
        fontSize_px: look.fontSize_px,
        fontFamily: look.fontFamily,
        onPoint: (index) => point.current?.(index),
        marks: () => marked.current,
      }),
      aligned(fitting(newest.current, series.length)),
      element,
    );
    plot.current = made;
    const resized = new ResizeObserver(() => made.setSize(sizeOf(element)));
    resized.observe(element);
    const dressed = new MutationObserver(() => {
      look = lookOf(element);
      made.redraw(false, true);
    });
    dressed.observe(document.documentElement, { attributeFilter: ["data-theme"] });
    return () => {
      resized.disconnect();
      dressed.disconnect();
      made.destroy();
      plot.current = null;
    };
  }, [series, window_s, secondsUnit]);

  useImperativeHandle(
    ref,
    () => ({
      draw(data, marks = []) {
        newest.current = data;
        marked.current = marks;
        plot.current?.setData(aligned(data));
      },
    }),
    [],
  );
  return <div ref={box} className="ui-plot" aria-hidden="true" />;
}

/** The last drawn data, if it has the same number of series. */
function fitting(data: PlotData | null, count: number): PlotData {
  return data !== null && data.length === count + 1
    ? data
    : [[], ...Array.from({ length: count }, (): number[] => [])];
}

/** uPlot's type demands mutable arrays, but it does not change them. */
function aligned(data: PlotData): uPlot.AlignedData {
  return data as unknown as uPlot.AlignedData;
}

interface PlotOptions extends Look {
  readonly series: readonly PlotSeries[];
  readonly window_s: number;
  readonly secondsUnit: string;
  readonly size: { readonly width: number; readonly height: number };
  readonly onPoint: (index: number | null) => void;
  readonly marks: () => readonly PlotMark[];
}

function options(wanted: PlotOptions): uPlot.Options {
  const { series, window_s, secondsUnit, size, colour, fontSize_px, onPoint, marks } = wanted;
  const units = [...new Set(series.map(({ unit }) => unit))];
  const look = axisLook(wanted);
  return {
    ...size,
    legend: { show: false },
    cursor: { drag: { x: false, y: false }, points: { size: 6 }, y: false },
    scales: {
      x: { time: false, range: [-window_s, 0] },
      ...Object.fromEntries(units.map((unit) => [scaleOf(unit), { range: rangeOf(series, unit) }])),
    },
    axes: [
      {
        ...look,
        size: 2 * fontSize_px,
        values: (_, splits) => splits.map((split) => `${split} ${secondsUnit}`),
      },
      ...units.slice(0, MOST_AXES).map(
        (unit, index): uPlot.Axis => ({
          ...look,
          scale: scaleOf(unit),
          side: index % 2 === 0 ? 3 : 1,
          size: (_, values) => axisWidth(values, fontSize_px),
          ...(index === 0 ? {} : { grid: { show: false } }),
          ...(unit === "" ? {} : { label: unit, labelSize: 1.5 * fontSize_px, labelGap: 0 }),
        }),
      ),
    ],
    series: [
      {},
      ...series.map(
        ({ unit }, index): uPlot.Series => ({
          scale: scaleOf(unit),
          stroke: () => colour(plotColour(index)),
          width: 1.5,
          dash: [...(PLOT_DASHES[index % PLOT_DASHES.length] ?? [])],
          points: { show: false },
        }),
      ),
    ],
    hooks: {
      setCursor: [({ cursor }) => onPoint(cursor.idx ?? null)],
      draw: [(plot) => drawMarks(plot, marks(), colour("--text"), look.font)],
    },
  };
}

function rangeOf(series: readonly PlotSeries[], unit: string) {
  const least_span = Math.max(...series.filter((one) => one.unit === unit).map((one) => one.least_span ?? 0));
  return least_span > 0 ? steady(least_span) : roomy;
}

/** A line from top to bottom for each mark, its label beside its top; later ones a line lower, so that none is covered. */
function drawMarks(plot: uPlot, marks: readonly PlotMark[], colour: string, font: string): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.font = font.replace(/^([\d.]+)px/, (_, px) => `${Number(px) * devicePixelRatio}px`);
  ctx.fillStyle = colour;
  ctx.strokeStyle = colour;
  ctx.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
  const line_px = 1.2 * (Number.parseFloat(font) || 12) * devicePixelRatio;
  for (const [index, { before_s, label }] of marks.entries()) {
    const x = Math.round(plot.valToPos(before_s, "x", true));
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    // At the right end there is no room beside the line.
    const isLeft = x + ctx.measureText(label).width + 8 > bbox.left + bbox.width;
    ctx.textAlign = isLeft ? "right" : "left";
    ctx.fillText(label, x + (isLeft ? -4 : 4), bbox.top + line_px * (1 + (index % 3)));
  }
  ctx.restore();
}
