import { useCallback, useEffect, useMemo, useRef } from "react";
import { type HistoryWindow, SignalHistory } from "../lib/signalHistory";
import { usePage, usePart } from "../store/hooks";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { pastRows } from "./pastRows";
import { SIGNAL_PAST } from "./signalPast";
import { liveSignal, operandsOf, type Signal, signalKey } from "./signals";

/** Shortest time between rows: a little under the period of 60 Hz. */
const ROW_MS = 15;
/** An unchanged value is recorded this often, so that the line before a step is flat. */
const HELD_MS = 95;
/** A longer pause of the page is drawn as a gap, as are samples that are further from each other. */
const LAPSE_MS = 1000;

/** The signals' values in the window that ends now. */
type Recording = (telemetry: TelemetryStore, now_ms: number) => HistoryWindow;

/**
 * Records the signals' values in each animation frame. Signals that stay keep their past when others are added or
 * removed. `fromRecording`: what was before is asked of the station, whenever the signals change.
 */
export function useRecording(
  signals: readonly Signal[],
  window_s: number,
  fromRecording: boolean,
): Recording {
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
  usePastRows(fromRecording ? signals : NONE, window_s, history);

  return useCallback(
    (telemetry, now_ms) =>
      history.current?.window(telemetry.axis_s(now_ms), window_s) ?? { before_s: [], values: new Map() },
    [window_s],
  );
}

const NONE: readonly Signal[] = [];

/** Puts the recorded seconds before these signals were chosen in front of what was gathered since, once. */
function usePastRows(
  signals: readonly Signal[],
  window_s: number,
  history: { current: SignalHistory | null },
): void {
  const page = usePage();
  const past = usePart(SIGNAL_PAST);
  const asked = useRef<readonly Signal[]>(NONE);
  const ask = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const clock_s = telemetry.clock_s(now_ms);
      if (asked.current === signals || clock_s === null) {
        return;
      }
      asked.current = signals;
      const recorded = [...new Set(signals.flatMap(operandsOf))];
      if (recorded.length === 0) {
        return;
      }
      const { jumps } = telemetry;
      const opened_s = telemetry.axis_s(now_ms);
      const offset_s = opened_s - clock_s;
      void past.ask(page, recorded, clock_s - window_s, clock_s).then((answer) => {
        if (answer !== null && asked.current === signals && telemetry.jumps === jumps) {
          const rows = pastRows(answer, signals, { step_s: ROW_MS / 1000, lapse_s: LAPSE_MS / 1000 });
          const onAxis = rows.map(({ time_s, read }) => ({ time_s: time_s + offset_s, read }));
          history.current = history.current?.after(onAxis, opened_s) ?? null;
        }
      });
    },
    [page, past, signals, window_s, history],
  );
  usePaint("text", ask);
}
