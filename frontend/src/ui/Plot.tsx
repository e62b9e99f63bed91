import { type Ref, useEffect, useImperativeHandle, useRef } from "react";
import type uPlot from "uplot";
import { drawnPlot, lineLook, unitAxes, unitsOf } from "./drawnPlot";
import "./Plot.css";
import { axisLook, type Look, roomy, scaleOf, steady } from "./plotLook";
import { drawMarks, type PlotMark } from "./plotMarks";

/** Times in seconds relative to now (zero or less), and each series' values; null is a gap. */
export type PlotData = readonly [readonly number[], ...ReadonlyArray<ReadonlyArray<number | null>>];

export interface PlotHandle {
  /** Draw these; the plot always spans from `window_s` before now to now. */
  draw(data: PlotData, marks?: readonly PlotMark[]): void;
}

export interface PlotSeries {
  readonly key: string;
  /** Stands at the axis of what has no unit. */
  readonly name: string;
  /** Series of one unit share an axis. */
  readonly unit: string;
  /** The axis spans at least this, and ends at round numbers; the greatest of a unit counts. */
  readonly least_span?: number | undefined;
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
    const made = drawnPlot(
      element,
      (look) =>
        options({
          ...look,
          series,
          window_s,
          secondsUnit,
          onPoint: (index) => point.current?.(index),
          marks: () => marked.current,
        }),
      aligned(fitting(newest.current, series.length)),
    );
    plot.current = made.plot;
    return () => {
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
  readonly onPoint: (index: number | null) => void;
  readonly marks: () => readonly PlotMark[];
}

function options(wanted: PlotOptions): Omit<uPlot.Options, "width" | "height"> {
  const { series, window_s, secondsUnit, colour, fontSize_px, onPoint, marks } = wanted;
  const units = unitsOf(series);
  const look = axisLook(wanted);
  return {
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
      ...unitAxes(units, wanted, namesWithoutUnit(series)),
    ],
    series: [
      {},
      ...series.map(
        ({ unit }, index): uPlot.Series => ({
          ...lineLook(unit, index, wanted),
          width: 1.5,
          points: { show: false },
        }),
      ),
    ],
    hooks: {
      setCursor: [({ cursor }) => onPoint(cursor.idx ?? null)],
      draw: [
        (plot) =>
          drawMarks(plot, marks(), {
            text: colour("--text"),
            ground: colour("--surface-well"),
            font: look.font,
            ratio: devicePixelRatio,
          }),
      ],
    },
  };
}

function namesWithoutUnit(series: readonly PlotSeries[]): string {
  return series.flatMap(({ unit, name }) => (unit === "" ? [name] : [])).join(", ");
}

function rangeOf(series: readonly PlotSeries[], unit: string) {
  const least_span = Math.max(...series.filter((one) => one.unit === unit).map((one) => one.least_span ?? 0));
  return least_span > 0 ? steady(least_span) : roomy;
}
