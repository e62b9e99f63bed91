import "./plot.css";
import { Pause, Play } from "lucide-react";
import { useCallback, useEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatAge, formatMeasured } from "../lib/format";
import { extent, type HistoryWindow, SignalHistory } from "../lib/signalHistory";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { Button } from "../ui/Button";
import { Notice } from "../ui/Notice";
import type { PlotData, PlotHandle, PlotMark } from "../ui/Plot";
import { PlotKey, type PlotKeyHandle } from "./PlotKey";
import { liveSignal, type Signal, signalKey } from "./signals";
import { useLazyPlot } from "./useLazyPlot";

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
}

export interface PlotEvent {
  readonly key: string;
  readonly label: string;
}

const NO_EVENTS: readonly PlotEvent[] = [];

/** Shortest time between rows: a little under the period of 60 Hz. */
const ROW_MS = 15;
/** An unchanged value is recorded this often, so that the line before a step is flat. */
const HELD_MS = 95;
/** A longer pause of the page is drawn as a gap. */
const LAPSE_MS = 1000;
const SUMMARY_MS = 1000;

/**
 * Signals over the last seconds, with gaps where they were not live: recorded in each animation frame, drawn ten
 * times a second, all without a render. A pause stops the drawing, not the recording. A sentence describes the plot.
 */
export function LivePlot({ signals, window_s = 30, height, label, events = NO_EVENTS }: Props) {
  const { t } = useTranslation();
  const plot = useRef<PlotHandle>(null);
  const key = useRef<PlotKeyHandle>(null);
  const summary = useRef<HTMLParagraphElement>(null);
  const [isPaused, setPaused] = useState(false);
  const shown = useStable(signals);
  const recording = useRecording(shown, window_s);
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

/** The signals' values in the window that ends now. */
type Recording = (telemetry: TelemetryStore, now_ms: number) => HistoryWindow;

/**
 * Records the signals' values in each animation frame. Signals that stay keep their past when others are added or
 * removed.
 */
function useRecording(signals: readonly Signal[], window_s: number): Recording {
  const history = useRef<SignalHistory | null>(null);
  const keys = useMemo(() => signals.map(signalKey), [signals]);
  const capacity = Math.ceil((window_s * 1000) / ROW_MS) + 1;
  useEffect(() => {
    history.current = history.current?.withKeys(keys, capacity) ?? new SignalHistory(keys, capacity);
  }, [keys, capacity]);

  const last = useRef({ at_ms: Number.NEGATIVE_INFINITY, values: "", jumps: 0 });
  const keep = useCallback(
    (telemetry: TelemetryStore, page_ms: number) => {
      const now_ms = telemetry.axis_s(page_ms) * 1000;
      const { jumps } = telemetry;
      if (jumps !== last.current.jumps) {
        // A playback went back: what was recorded lies after what comes.
        last.current = { at_ms: Number.NEGATIVE_INFINITY, values: "", jumps };
        history.current?.clear();
      }
      const values = new Map(
        signals.map((signal) => [signalKey(signal), liveSignal(telemetry, signal, page_ms)]),
      );
      const text = [...values.values()].join();
      const since_ms = now_ms - last.current.at_ms;
      if (since_ms >= HELD_MS || (text !== last.current.values && since_ms >= ROW_MS)) {
        if (since_ms > LAPSE_MS) {
          history.current?.append(now_ms / 1000, () => null);
        }
        last.current = { at_ms: now_ms, values: text, jumps };
        history.current?.append(now_ms / 1000, (name) => values.get(name) ?? null);
      }
    },
    [signals],
  );
  usePaint("movement", keep);

  return useCallback(
    (telemetry, now_ms) =>
      history.current?.window(telemetry.axis_s(now_ms), window_s) ?? { before_s: [], values: new Map() },
    [window_s],
  );
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
