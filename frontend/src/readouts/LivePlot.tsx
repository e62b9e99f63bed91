import "./plot.css";
import { Pause, Play } from "lucide-react";
import { useCallback, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatAge, formatMeasured } from "../lib/format";
import { extent, type HistoryWindow } from "../lib/signalHistory";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { Button } from "../ui/Button";
import { Notice } from "../ui/Notice";
import type { PlotData, PlotHandle } from "../ui/Plot";
import type { PlotMark } from "../ui/plotMarks";
import { PlotKey, type PlotKeyHandle } from "./PlotKey";
import { type Signal, signalKey } from "./signals";
import { useLazyPlot } from "./useLazyPlot";
import { useRecording } from "./useRecording";

interface Props {
  signals: readonly Signal[];
  /** Time span of the plot. */
  window_s?: number;
  /** A CSS length; by default the plot fills its container. */
  height?: string;
  /** Accessible name. */
  label: string;
  /** What happened, in its order: each is marked at the moment at which it was first given. */
  events?: readonly PlotEvent[];
  /** Begin with what the station recorded before the plot was opened. */
  fromRecording?: boolean;
}

export interface PlotEvent {
  readonly key: string;
  readonly label: string;
}

const NO_EVENTS: readonly PlotEvent[] = [];

const SUMMARY_MS = 1000;

/**
 * Signals over the last seconds, with gaps where they were not live: recorded in each animation frame, drawn ten
 * times a second, all without a render. A pause stops the drawing, not the recording. A sentence describes the plot.
 */
export function LivePlot({
  signals,
  window_s = 30,
  height,
  label,
  events = NO_EVENTS,
  fromRecording = false,
}: Props) {
  const { t } = useTranslation();
  const plot = useRef<PlotHandle>(null);
  const key = useRef<PlotKeyHandle>(null);
  const summary = useRef<HTMLParagraphElement>(null);
  const [isPaused, setPaused] = useState(false);
  const shown = useStable(signals);
  const recording = useRecording(shown, window_s, fromRecording);
  const marksAt = useMarks(events);
  const point = useRef<number | null>(null);
  const frozen = useRef<{ window: HistoryWindow; marks: readonly PlotMark[] } | null>(null);
  const said = useRef<{ say: unknown; at_ms: number }>({ say: null, at_ms: Number.NEGATIVE_INFINITY });
  const drawn = useRef<readonly Signal[] | null>(null);
  const { Plot, failed } = useLazyPlot();

  const say = useCallback(
    (window: HistoryWindow, marks: readonly PlotMark[]): string =>
      [
        ...shown.map((signal) => {
          const values = window.values.get(signalKey(signal)) ?? [];
          const newest = formatMeasured(values.at(-1) ?? null);
          const range = extent(values);
          return newest === null || range === null
            ? t("plot.signalNone", { name: signal.label })
            : t("plot.signal", {
                name: signal.label,
                value: newest,
                unit: signal.unit ?? "",
                minimum: formatMeasured(range.min) ?? "",
                maximum: formatMeasured(range.max) ?? "",
              });
        }),
        ...marks
          .filter(({ before_s }) => before_s >= -window_s)
          .map(({ before_s, label: event }) => t("plot.event", { event, ago: formatAge(-before_s) })),
      ].join(" "),
    [shown, t, window_s],
  );

  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const seen = (isPaused ? frozen.current : null) ?? {
        window: recording(telemetry, now_ms),
        marks: marksAt(telemetry, now_ms),
      };
      const { window, marks } = seen;
      frozen.current = seen;
      // A paused plot is redrawn only when its signals change.
      if (plot.current !== null && !(isPaused && drawn.current === shown)) {
        plot.current.draw(dataOf(window, shown), marks);
        drawn.current = shown;
      }
      key.current?.paint(shown.map((signal) => valueAt(window, signal, point.current)));
      if (
        summary.current !== null &&
        (said.current.say !== say || now_ms - said.current.at_ms >= SUMMARY_MS)
      ) {
        said.current = { say, at_ms: now_ms };
        summary.current.textContent = say(window, marks);
      }
    },
    [isPaused, recording, shown, say, marksAt],
  );
  usePaint("text", paint);

  const series = useMemo(
    () =>
      shown.map((signal) => ({
        key: signalKey(signal),
        name: signal.label,
        unit: signal.unit ?? "",
        least_span: signal.least_span,
      })),
    [shown],
  );
  const onPoint = useCallback((index: number | null) => {
    point.current = index;
  }, []);
  return (
    <figure className="live-plot" aria-label={label} style={height === undefined ? undefined : { height }}>
      <figcaption className="live-plot-head">
        <PlotKey ref={key} signals={shown} />
        <Button
          onPress={() => setPaused(!isPaused)}
          pressed={isPaused}
          icon={isPaused ? <Play aria-hidden="true" size={14} /> : <Pause aria-hidden="true" size={14} />}
        >
          {t("plot.pause")}
        </Button>
      </figcaption>
      <div className="live-plot-picture">
        {Plot !== null && (
          <Plot ref={plot} series={series} window_s={window_s} secondsUnit={t("unit.s")} onPoint={onPoint} />
        )}
        {failed && <Notice level="error">{t("plot.failed")}</Notice>}
      </div>
      <p ref={summary} className="visually-hidden" />
    </figure>
  );
}

/** The same array as long as the signals are equal. */
function useStable(signals: readonly Signal[]): readonly Signal[] {
  const [kept, setKept] = useState(signals);
  if (kept !== signals && identity(kept) !== identity(signals)) {
    setKept(signals);
    return signals;
  }
  return kept;
}

function identity(signals: readonly Signal[]): string {
  return signals.map((signal) => `${signalKey(signal)} ${signal.label}`).join("\n");
}

function dataOf({ before_s, values }: HistoryWindow, signals: readonly Signal[]): PlotData {
  return [
    before_s,
    ...signals.map((signal) =>
      brokenAtTurns(values.get(signalKey(signal)) ?? before_s.map(() => null), signal.turn),
    ),
  ];
}

/** Without the lines across the whole picture where an angle goes on at the other end. */
function brokenAtTurns(
  values: ReadonlyArray<number | null>,
  turn: number | undefined,
): ReadonlyArray<number | null> {
  if (turn === undefined) {
    return values;
  }
  return values.map((value, index) => {
    const before = values[index - 1] ?? value;
    return value !== null && before !== null && Math.abs(value - before) > turn / 2 ? null : value;
  });
}

/** The events as marks at the moments at which they were first given; all are forgotten when a playback jumps. */
function useMarks(
  events: readonly PlotEvent[],
): (telemetry: TelemetryStore, now_ms: number) => readonly PlotMark[] {
  const first = useRef<{ jumps: number; at_s: Map<string, number> }>({ jumps: 0, at_s: new Map() });
  const mark = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const at_s = telemetry.axis_s(now_ms);
      if (first.current.jumps !== telemetry.jumps) {
        // Marks after the moment gone back to have not happened yet.
        first.current = {
          jumps: telemetry.jumps,
          at_s: new Map(events.map(({ key }) => [key, Number.NEGATIVE_INFINITY])),
        };
      }
      for (const { key } of events) {
        if (!first.current.at_s.has(key)) {
          first.current.at_s.set(key, at_s);
        }
      }
    },
    [events],
  );
  usePaint("movement", mark);
  return useCallback(
    (telemetry, now_ms) => {
      const now_s = telemetry.axis_s(now_ms);
      return events.flatMap(({ key, label }): readonly PlotMark[] => {
        const at_s = first.current.at_s.get(key);
        return at_s === undefined || !Number.isFinite(at_s) ? [] : [{ before_s: at_s - now_s, label }];
      });
    },
    [events],
  );
}

/** The value under the pointer; without a pointer, the newest. */
function valueAt({ values }: HistoryWindow, signal: Signal, index: number | null): number | null {
  return values.get(signalKey(signal))?.at(index ?? -1) ?? null;
}
