import { useCallback, useEffect, useLayoutEffect, useRef } from "react";
import { usePage, usePart } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { type Panes, signalsOf } from "./plotLayouts";
import { PLOTS, type Plots } from "./plots";
import { type Stretch, stretchOf, type View } from "./plotView";
import { parseSignal } from "./signalNames";
import { useFeed, usePlotsState } from "./usePlots";

/** The gateway cuts a stretch where the flight ends. */
const END_S = 10_000_000;
/** The flight under way is asked for again so often; a long one, which takes longer to answer, less often. */
const AGAIN_S = 2;
const MOST_AGAIN_S = 20;
const SHARE = 120;

/** How far the shown flight goes, seconds since its start; zero while not known. */
export function edgeOf(plots: Plots, telemetry: TelemetryStore, now_ms: number): number {
  const { flight, edge_s } = plots.timeline.store.getState();
  const { starts_s, to_s } = plots.feed.store.getState();
  if (flight !== null) {
    return Math.max(edge_s, to_s);
  }
  const clock_s = telemetry.clock_s(now_ms);
  return Math.max(to_s, starts_s === null || clock_s === null ? 0 : clock_s - starts_s);
}

/** The stretch to ask for of the shown flight, and of the one that is laid over it. */
function questions(
  view: View,
  edge_s: number,
  isBegun: boolean,
): { readonly mine: Stretch; readonly other: Stretch } {
  // Before the first answer nobody knows how far the flight goes.
  if (view.kind === "all" || (view.kind === "last" && !isBegun)) {
    const whole = { from_s: 0, to_s: END_S };
    return { mine: whole, other: edge_s > 0 ? { from_s: 0, to_s: edge_s } : whole };
  }
  const stretch = stretchOf(view, edge_s);
  return { mine: view.kind === "last" ? { ...stretch, to_s: END_S } : stretch, other: stretch };
}

/** Keep asking for what the panes show: at once when it changes, and again and again while the flight grows. */
export function useAsking(subject: string | null, panes: Panes, points: number): void {
  const plots = usePart(PLOTS);
  const { telemetry, pump } = usePage();
  const view = usePlotsState((state) => state.view);
  const compared = usePlotsState((state) => state.compared);
  const shift_s = usePlotsState((state) => state.shift_s);
  const isBegun = useFeed("feed", (state) => state.starts_s !== null);
  const asked_ms = useRef(0);
  const names = signalsOf(panes).join(" ");

  const ask = useCallback(
    (anew: boolean) => {
      asked_ms.current = pump.now_ms;
      const edge_s = edgeOf(plots, telemetry, pump.now_ms);
      const { mine, other } = questions(view, edge_s, isBegun);
      const wanted = { names: names === "" ? [] : names.split(" "), points };
      plots.feed.want(subject === null ? null : { ...wanted, ...mine, flight: subject, shift_s: 0 }, anew);
      const isOver = subject !== null && compared !== null;
      plots.other.want(isOver ? { ...wanted, ...other, flight: compared, shift_s } : null);
    },
    [plots, telemetry, pump, view, compared, shift_s, names, points, subject, isBegun],
  );
  // Before the plots draw what they have: the gateway looks for the rest meanwhile.
  useLayoutEffect(() => ask(false), [ask]);

  const again = useCallback(() => {
    const { starts_s, to_s, failure } = plots.feed.store.getState();
    const edge_s = edgeOf(plots, telemetry, pump.now_ms);
    const every_s = Math.min(MOST_AGAIN_S, Math.max(AGAIN_S, edge_s / SHARE));
    const isDue = pump.now_ms - asked_ms.current >= every_s * 1000 && failure === null && starts_s !== null;
    const hasGrown = edge_s > to_s && (view.kind !== "stretch" || view.to_s > to_s);
    if (subject !== null && isDue && hasGrown) {
      ask(true);
    }
  }, [plots, telemetry, pump, ask, subject, view]);
  usePaint("text", again);

  useEffect(() => {
    plots.tail.follow([...new Set(names.split(" ").flatMap((name) => parseSignal(name)?.operands ?? []))]);
  }, [plots, names]);

  const gather = useCallback(
    (received: TelemetryStore) => {
      if (!received.isPast) {
        plots.tail.take(received);
      }
    },
    [plots],
  );
  usePaint("movement", gather);
}
