import { createStore, type StoreApi } from "zustand/vanilla";
import type { Timers } from "../../lib/timers";
import type { Gateway } from "../../requests/asking";
import { partName } from "../../store/parts";
import { LiveTail } from "./liveTail";
import { createPlotFeed, type PlotFeed } from "./plotFeed";
import { ALL, LAST, type View } from "./plotView";

/** The flight that is being recorded. */
export const CURRENT = "current";

/** The time that the page shows. Seconds since the flight's start. */
export interface ShownTime {
  /** The flight of the past that is shown; null: the present. */
  readonly flight: string | null;
  readonly at_s: number;
  /** How far the flight of the past goes. */
  readonly edge_s: number;
}

/** The page's time as the plots need it: who shows it is connected by app. */
export interface PlotTimeline {
  readonly store: StoreApi<ShownTime>;
  /** Show this moment of the flight that is shown; in the present, of the one that is being recorded. */
  readonly seek: (at_s: number) => void;
  /** Show another flight. */
  readonly open: (flight: string) => void;
}

export interface PlotsState {
  /** The plot that takes the signals that are chosen. */
  readonly active: number;
  readonly view: View;
  /** A second flight, laid over by its own start; null: none. */
  readonly compared: string | null;
  /** Seconds that the second flight is drawn earlier. */
  readonly shift_s: number;
}

export interface Plots {
  readonly store: StoreApi<PlotsState>;
  readonly timeline: PlotTimeline;
  readonly feed: PlotFeed;
  /** The signals of the second flight. */
  readonly other: PlotFeed;
  readonly tail: LiveTail;
  readonly rest: Gateway;
  readonly timers: Timers;
  /** Open one flight with another laid over it. */
  readonly compare: (flight: string, other: string) => void;
}

export const PLOTS = partName<Plots>("plots");

interface Parts {
  readonly rest: Gateway;
  readonly timers: Timers;
  readonly timeline: PlotTimeline;
}

export function createPlots({ rest, timers, timeline }: Parts): Plots {
  const store = createStore<PlotsState>(() => ({ active: 0, view: LAST, compared: null, shift_s: 0 }));
  const tail = new LiveTail();

  timeline.store.subscribe(({ flight }, { flight: before }) => {
    if (flight === before) {
      return;
    }
    if (flight === null) {
      store.setState({ view: LAST });
      tail.clear();
    } else if (before !== CURRENT && (flight !== CURRENT || store.getState().view.kind === "last")) {
      // The flight under way keeps the stretch that somebody chose; its name comes only with the first answer.
      store.setState({ view: ALL });
    }
  });

  return {
    store,
    timeline,
    feed: createPlotFeed(rest),
    other: createPlotFeed(rest),
    tail,
    rest,
    timers,
    compare: (flight, other) => {
      timeline.open(flight);
      store.setState({ compared: other, shift_s: 0, view: ALL });
    },
  };
}
