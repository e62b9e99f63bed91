import { useCallback, useMemo } from "react";
import { useStore } from "zustand";
import { useConnection, usePage, usePart, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import type { FeedState } from "./plotFeed";
import { FIRST, type Panes, readPanes, withPlotOf } from "./plotLayouts";
import { CURRENT, PLOTS, type PlotsState, type ShownTime } from "./plots";

export function usePlotsState<T>(select: (state: PlotsState) => T): T {
  return useStore(usePart(PLOTS).store, select);
}

export function useShownTime<T>(select: (time: ShownTime) => T): T {
  return useStore(usePart(PLOTS).timeline.store, select);
}

/** What is known of the shown flight, or of the one that is laid over it. */
export function useFeed<T>(which: "feed" | "other", select: (state: FeedState) => T): T {
  return useStore(usePart(PLOTS)[which].store, select);
}

/** The flight whose signals are drawn: the one that is shown, or that is being recorded; null: none. */
export function useSubject(): string | null {
  const flight = useShownTime((time) => time.flight);
  // A line that broke leaves what was drawn: the next answer says why there is nothing new.
  const isRecording = useConnection(({ status }) => status?.recording.active === true);
  return flight ?? (isRecording ? CURRENT : null);
}

const CHOICE = "plots.panes";

/** The panes as this person left them, and how to change them. */
export function usePanes(): readonly [Panes, (panes: Panes) => void] {
  const { settings } = usePage();
  const stored = useSettings(({ choices }) => choices[CHOICE]);
  const panes = useMemo(() => readPanes(stored) ?? FIRST, [stored]);
  const set = useCallback((next: Panes) => choose(settings, CHOICE, JSON.stringify(next)), [settings]);
  return [panes, set];
}

/** Has a plot of a signal among the panes. */
export function useShowSignal(): (name: string) => void {
  const { store } = usePart(PLOTS);
  const [panes, setPanes] = usePanes();
  return (name) => {
    const shown = withPlotOf(panes, name);
    setPanes(shown.panes);
    store.setState({ active: shown.pane });
  };
}
