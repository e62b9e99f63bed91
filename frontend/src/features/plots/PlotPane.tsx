import { ArrowDown, ArrowUp, Trash2, X } from "lucide-react";
import { type RefObject, useCallback, useEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatMeasured } from "../../lib/format";
import { usePage, usePart } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Button } from "../../ui/Button";
import { PLOT_DASHES, plotColour } from "../../ui/plotColours";
import { Chart } from "./chart";
import type { ChartListener } from "./chartGestures";
import type { PlotSeries } from "./drawn";
import { isFresh, valueText } from "./figures";
import { isThere } from "./plotFeed";
import { PLOTS } from "./plots";
import { formatAt, stretchOf } from "./plotView";
import { signalLabel, unitSymbol } from "./signalNames";
import { edgeOf } from "./useAsking";
import { useFeed, usePlotsState } from "./usePlots";

/** A live plot is drawn anew when it has moved by as many pixels: its axes and their words take longer than its lines. */
const STEP_PX = 2;

interface Props {
  readonly number: number;
  readonly count: number;
  readonly signals: readonly string[];
  readonly isActive: boolean;
  readonly listener: Omit<ChartListener, "onHover">;
  readonly charts: RefObject<Map<number, PaneHandle>>;
  /** Name of the flight that is laid over; null: none. */
  readonly otherName: string | null;
  readonly onChoose: () => void;
  readonly onMove: (by: 1 | -1) => void;
  readonly onRemove: () => void;
  readonly onRemoveSignal: (name: string) => void;
}

/** What a pane gives to the picture. */
export interface PaneHandle {
  readonly chart: Chart;
  readonly lines: readonly Line[];
}

export interface Line {
  readonly key: string;
  readonly drawn: PlotSeries;
  readonly isOther: boolean;
}

/** One plot with the figures of its signals, which are also its text for who does not see it. */
export function PlotPane(props: Props) {
  const { number, count, signals, isActive, otherName } = props;
  const { t } = useTranslation();
  const lines = useLines(signals, otherName !== null);
  const box = useRef<HTMLDivElement>(null);
  const values = useRef(new Map<string, HTMLElement>());
  useChart(props, lines, box, values.current);
  return (
    <section className="plots-pane" aria-label={t("plots.pane", { number })} data-active={isActive}>
      <header className="plots-pane-head">
        <Button onPress={props.onChoose} pressed={isActive} label={t("plots.choosePane", { number })}>
          {t("plots.pane", { number })}
        </Button>
        <span className="plots-gap" />
        {number > 1 && (
          <Button
            onPress={() => props.onMove(-1)}
            label={t("plots.up", { number })}
            icon={<ArrowUp aria-hidden="true" size={14} />}
          >
            {null}
          </Button>
        )}
        {number < count && (
          <Button
            onPress={() => props.onMove(1)}
            label={t("plots.down", { number })}
            icon={<ArrowDown aria-hidden="true" size={14} />}
          >
            {null}
          </Button>
        )}
        <Button
          onPress={props.onRemove}
          label={t("plots.removePane", { number })}
          icon={<Trash2 aria-hidden="true" size={14} />}
        >
          {null}
        </Button>
      </header>
      <div ref={box} className="plots-chart" aria-hidden="true" />
      {signals.length === 0 ? (
        <p className="plots-empty">{t("plots.emptyPane")}</p>
      ) : (
        <Figures {...props} lines={lines} values={values.current} />
      )}
    </section>
  );
}

/** The lines of a pane: the signals that are known, and those of the flight that is laid over. */
function useLines(signals: readonly string[], isCompared: boolean): readonly Line[] {
  const mine = useFeed("feed", (state) => state.signals);
  const others = useFeed("other", (state) => state.signals);
  return useMemo(() => {
    const of = (known: ReadonlyMap<string, PlotSeries>, isOther: boolean): Line[] =>
      signals.flatMap((name) => {
        const drawn = known.get(name);
        return drawn === undefined ? [] : [{ key: isOther ? `other ${name}` : name, drawn, isOther }];
      });
    return [...of(mine, false), ...(isCompared ? of(others, true) : [])];
  }, [signals, mine, others, isCompared]);
}

/** Makes the chart anew when its lines are others; draws it when anything of it has changed. */
function useChart(
  { number, listener, charts }: Props,
  lines: readonly Line[],
  box: RefObject<HTMLDivElement | null>,
  values: ReadonlyMap<string, HTMLElement>,
): void {
  const { t } = useTranslation();
  const dash = t("words.dash");
  const plots = usePart(PLOTS);
  const { telemetry, pump } = usePage();
  const view = usePlotsState((state) => state.view);
  const chart = useRef<Chart | null>(null);
  const hover_s = useRef<number | null>(null);
  const done = useRef("");
  const again_ms = useRef(0);
  const newest = useRef(lines);
  const identity = lines.map(({ key, drawn }) => `${key} ${drawn.unit}`).join("\n");

  const paint = useCallback(
    (received: TelemetryStore, now_ms: number) => {
      const { flight, at_s } = plots.timeline.store.getState();
      const { starts_s, to_s } = plots.feed.store.getState();
      const isLive = flight === null && !received.isPast;
      const stretch = stretchOf(view, edgeOf(plots, received, now_ms));
      const shown = newest.current.map(({ drawn, isOther }) =>
        isLive && !isOther && starts_s !== null ? plots.tail.extend(drawn, starts_s, to_s) : drawn,
      );
      const state = `${stretch.from_s} ${stretch.to_s} ${isLive ? plots.tail.revision : ""}`;
      const isSoon = isLive && done.current !== "" && now_ms < again_ms.current;
      if (state !== done.current && !isSoon && chart.current !== null) {
        done.current = state;
        again_ms.current = now_ms + STEP_PX * 1000 * chart.current.pixel_s(stretch);
        chart.current.draw(shown, stretch);
      }
      const moment_s = isLive ? null : at_s;
      chart.current?.showMoment(moment_s);
      paintValues(newest.current, values, dash, ({ drawn: { name }, isOther }, index) => {
        const drawn = shown[index];
        const isOld = isLive && hover_s.current === null && (isOther || !isFresh(received, name, now_ms));
        return drawn === undefined || isOld ? null : valueText(drawn, hover_s.current ?? moment_s);
      });
    },
    [plots, view, values, dash],
  );
  usePaint("text", paint);

  // Effects run in their order: the chart's own, below, reads these lines.
  useEffect(() => {
    newest.current = lines;
  }, [lines]);
  const paints = useRef<() => void>(() => undefined);
  useEffect(() => {
    paints.current = () => paint(telemetry, pump.now_ms);
  }, [paint, telemetry, pump]);

  // biome-ignore lint/correctness/useExhaustiveDependencies: the lines' identity says when another chart is needed
  useEffect(() => {
    const element = box.current;
    if (element === null) {
      return undefined;
    }
    const made = new Chart(
      element,
      newest.current.map(({ key, drawn, isOther }) => ({ key, unit: unitSymbol(drawn.unit), isOther })),
      {
        ...listener,
        onHover: (at_s) => {
          hover_s.current = at_s;
          paints.current();
        },
      },
      plots.timers,
    );
    chart.current = made;
    done.current = "";
    paints.current();
    return () => {
      chart.current = null;
      made.destroy();
    };
  }, [identity, listener, plots, box]);

  useEffect(() => {
    done.current = "";
    paint(telemetry, pump.now_ms);
    const handles = charts.current;
    if (chart.current !== null) {
      handles.set(number, { chart: chart.current, lines });
    }
    return () => {
      handles.delete(number);
    };
  }, [paint, telemetry, pump, lines, charts, number]);
}

/** Each line's value into its cell of the table. */
function paintValues(
  lines: readonly Line[],
  cells: ReadonlyMap<string, HTMLElement>,
  none: string,
  textOf: (line: Line, index: number) => string | null,
): void {
  for (const [index, line] of lines.entries()) {
    const cell = cells.get(line.key);
    const text = textOf(line, index) ?? none;
    if (cell !== undefined && cell.textContent !== text) {
      cell.textContent = text;
    }
  }
}

interface FiguresProps extends Props {
  readonly lines: readonly Line[];
  readonly values: Map<string, HTMLElement>;
}

/** Value under the pointer, or at the moment, and the extremes and the mean of the stretch. */
function Figures({ number, signals, lines, values, otherName, onRemoveSignal }: FiguresProps) {
  const { t } = useTranslation();
  const topics = useFeed("feed", (state) => state.topics);
  const stretch = useFigureStretch();
  const others = lines.flatMap((line, index) => (line.isOther ? [{ line, index }] : []));
  return (
    <table className="plots-figures">
      <caption className="visually-hidden">{t("plots.figures", { number, ...stretch })}</caption>
      <thead>
        <tr>
          <th scope="col">{t("plots.signal")}</th>
          <th scope="col">{t("plots.value")}</th>
          <th scope="col">{t("plots.minimum")}</th>
          <th scope="col">{t("plots.mean")}</th>
          <th scope="col">{t("plots.maximum")}</th>
          <th scope="col">{t("plots.unit")}</th>
          <td />
        </tr>
      </thead>
      <tbody>
        {signals.map((name) => {
          const index = lines.findIndex((line) => !line.isOther && line.drawn.name === name);
          const line = lines[index];
          return (
            <tr key={name}>
              <th scope="row">
                {line !== undefined && <LineSample index={index} />}
                <span className="plots-name">{signalLabel(name)}</span>
              </th>
              {line === undefined ? (
                <td className="plots-missing" colSpan={5}>
                  {topics === null
                    ? t("words.dash")
                    : t(isThere(topics, name) ? "plots.loading" : "plots.missing")}
                </td>
              ) : (
                <Numbers line={line} values={values} />
              )}
              <td>
                <button
                  type="button"
                  className="plots-remove"
                  aria-label={t("plots.remove", { name: signalLabel(name) })}
                  onClick={() => onRemoveSignal(name)}
                >
                  <X aria-hidden="true" size={14} />
                </button>
              </td>
            </tr>
          );
        })}
        {others.map(({ line, index }) => (
          <tr key={line.key}>
            <th scope="row">
              <LineSample index={index} />
              <span className="plots-name">
                {t("words.grouped", { group: otherName ?? "", name: signalLabel(line.drawn.name) })}
              </span>
            </th>
            <Numbers line={line} values={values} />
            <td />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Numbers({ line, values }: { readonly line: Line; readonly values: Map<string, HTMLElement> }) {
  const { t } = useTranslation();
  const { drawn, key } = line;
  const dash = t("words.dash");
  if (drawn.count === 0) {
    return (
      <td className="plots-missing" colSpan={5}>
        {t("plots.noSamples")}
      </td>
    );
  }
  return (
    <>
      <td
        className="plots-number"
        ref={(element) => {
          if (element === null) {
            values.delete(key);
          } else {
            values.set(key, element);
          }
        }}
      />
      <td className="plots-number">{formatMeasured(drawn.least) ?? dash}</td>
      <td className="plots-number">{formatMeasured(drawn.mean) ?? dash}</td>
      <td className="plots-number">{formatMeasured(drawn.greatest) ?? dash}</td>
      <td className="plots-unit">{unitSymbol(drawn.unit)}</td>
    </>
  );
}

function LineSample({ index }: { readonly index: number }) {
  return (
    <svg className="plots-line" viewBox="0 0 28 8" aria-hidden="true">
      <path
        d="M0 4H28"
        style={{ stroke: `var(${plotColour(index)})` }}
        strokeDasharray={(PLOT_DASHES[index % PLOT_DASHES.length] ?? []).join(" ")}
      />
    </svg>
  );
}

/** The stretch of the figures in words. */
function useFigureStretch(): { readonly from: string; readonly to: string } {
  const view = usePlotsState((state) => state.view);
  const to_s = useFeed("feed", (state) => state.to_s);
  const stretch = stretchOf(view, to_s);
  const span_s = stretch.to_s - stretch.from_s;
  return { from: formatAt(stretch.from_s, span_s), to: formatAt(stretch.to_s, span_s) };
}
