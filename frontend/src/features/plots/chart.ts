import uPlot from "uplot";
import type { Timers } from "../../lib/timers";
import { type DrawnPlot, drawnPlot, lineLook, unitAxes, unitsOf } from "../../ui/drawnPlot";
import { plotColour } from "../../ui/plotColours";
import { axisLook, type Look, roomy, scaleOf } from "../../ui/plotLook";
import { ChartGestures, type ChartListener } from "./chartGestures";
import type { PlotSeries } from "./drawn";
import { formatAt, type Stretch } from "./plotView";

/** A line of the chart: signals of one unit share an axis. */
export interface ChartLine {
  readonly key: string;
  readonly unit: string;
  /** Of a second flight: drawn thinner. */
  readonly isOther: boolean;
}

/** The pointer is shown at the same moment in all charts. */
const SYNC = "plots";
const DRAG_PX = 4;
/** A chart is taken to be at least as wide, also before it has been laid out. */
const LEAST_PX = 100;
const MOST_FILL = "55";
/** Distances of times on the axis. */
const ROUND_S = [
  0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200,
];

/** One plot by uPlot: of each signal the least and the greatest value of each step, with the ground between them. */
export class Chart {
  readonly #drawn: DrawnPlot;
  readonly #plot: uPlot;
  readonly #moment: HTMLElement;
  readonly #gestures: ChartGestures;
  readonly #count: number;
  #stretch: Stretch = { from_s: 0, to_s: 1 };
  #moment_s: number | null = null;

  constructor(element: HTMLElement, lines: readonly ChartLine[], listener: ChartListener, timers: Timers) {
    this.#count = lines.length;
    this.#drawn = drawnPlot(
      element,
      (look) => ({
        ...options(
          lines,
          look,
          listener,
          () => this.#stretch,
          () => this.#gestures.cancelClick(),
        ),
        hooks: {
          setCursor: [
            (plot) => {
              const { left = -1 } = plot.cursor;
              listener.onHover(left < 0 ? null : plot.posToVal(left, "x"));
            },
          ],
          setSelect: [
            (plot) => {
              const { left, width } = plot.select;
              if (width >= DRAG_PX) {
                listener.onZoomTo(plot.posToVal(left, "x"), plot.posToVal(left + width, "x"));
                plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
              }
            },
          ],
          draw: [() => this.#placeMoment()],
        },
      }),
      empty(lines.length),
    );
    this.#plot = this.#drawn.plot;
    this.#moment = document.createElement("div");
    this.#moment.className = "plots-moment";
    this.#moment.hidden = true;
    this.#plot.over.append(this.#moment);
    this.#gestures = new ChartGestures(this.#plot.over, {
      momentAt: (x) => this.#plot.posToVal(x, "x"),
      span_s: () => this.#stretch.to_s - this.#stretch.from_s,
      listener,
      timers,
    });
  }

  get canvas(): HTMLCanvasElement {
    return this.#plot.ctx.canvas;
  }

  /** Draw the signals in the order of the lines; undefined: nothing is known of it. */
  draw(signals: ReadonlyArray<PlotSeries | undefined>, stretch: Stretch): void {
    this.#stretch = stretch;
    const known = signals.length === this.#count ? signals : [];
    const data = joined(known);
    this.#plot.batch(() => {
      this.#plot.setData(data ?? empty(this.#count), false);
      this.#plot.setScale("x", { min: stretch.from_s, max: stretch.to_s });
    });
  }

  /** Seconds of a stretch that one pixel shows. */
  pixel_s({ from_s, to_s }: Stretch): number {
    return (to_s - from_s) / Math.max(LEAST_PX, this.#plot.bbox.width / uPlot.pxRatio);
  }

  /** The moment that the time bar shows; null: none. */
  showMoment(at_s: number | null): void {
    this.#moment_s = at_s;
    this.#placeMoment();
  }

  destroy(): void {
    this.#gestures.end();
    this.#drawn.destroy();
  }

  #placeMoment(): void {
    const at_s = this.#moment_s;
    const { from_s, to_s } = this.#stretch;
    const isShown = at_s !== null && at_s >= from_s && at_s <= to_s;
    this.#moment.hidden = !isShown;
    if (isShown) {
      this.#moment.style.transform = `translateX(${this.#plot.valToPos(at_s, "x")}px)`;
    }
  }
}

function empty(count: number): uPlot.AlignedData {
  return [[], ...Array.from({ length: 2 * count }, (): number[] => [])];
}

/** Columns over the times of all signals: null is a gap, undefined is a time of another signal. */
function joined(signals: ReadonlyArray<PlotSeries | undefined>): uPlot.AlignedData | null {
  if (signals.length === 0) {
    return null;
  }
  const tables = signals.map((one) =>
    one === undefined ? [[], [], []] : [[...one.at_s], [...one.low], [...one.high]],
  );
  return uPlot.join(tables as uPlot.AlignedData[]);
}

function options(
  lines: readonly ChartLine[],
  look: Look,
  listener: ChartListener,
  stretch: () => Stretch,
  cancelClick: () => void,
): Omit<uPlot.Options, "width" | "height"> {
  const { colour, fontSize_px } = look;
  const units = unitsOf(lines);
  const axis = axisLook(look);
  return {
    legend: { show: false },
    cursor: {
      y: false,
      drag: { x: true, y: false, setScale: false, dist: DRAG_PX },
      points: { show: false },
      sync: {
        key: SYNC,
        setSeries: false,
        filters: { pub: (type) => type === "mousemove" || type === "mouseleave", sub: () => true },
      },
      bind: {
        dblclick: () => () => {
          cancelClick();
          listener.onAll();
          return null;
        },
      },
    },
    scales: {
      x: { time: false, range: () => [stretch().from_s, stretch().to_s] },
      ...Object.fromEntries(units.map((unit) => [scaleOf(unit), { range: roomy }])),
    },
    axes: [
      {
        ...axis,
        size: 2 * fontSize_px,
        space: 7 * fontSize_px,
        incrs: ROUND_S,
        values: (_, splits) => {
          const step_s = (splits[1] ?? 1) - (splits[0] ?? 0);
          return splits.map((split) => formatAt(split, 4 * step_s));
        },
      },
      // A label also without a unit, so that the charts below each other line up.
      ...unitAxes(units, look, " "),
    ],
    series: [
      {},
      ...lines.flatMap(({ unit, isOther }, index): uPlot.Series[] => {
        const edge: uPlot.Series = {
          ...lineLook(unit, index, look),
          width: isOther ? 1 : 1.5,
        };
        return [
          { ...edge, points: { show: false } },
          { ...edge, points: { size: 4 } },
        ];
      }),
    ],
    bands: lines.map((_, index) => ({
      series: [2 * index + 2, 2 * index + 1],
      fill: () => `${colour(plotColour(index))}${MOST_FILL}`,
    })),
  };
}
