import { createStore } from "zustand/vanilla";
import type { Playback } from "../features/playback/playbackRequests";
import type { PlaybackState } from "../features/playback/playbackState";
import { CURRENT, type PlotTimeline, type ShownTime } from "../features/plots/plots";

/** The time bar as the plots need it. */
export function plotTimeline(playback: Playback): PlotTimeline {
  const timeOf = ({ flight, at_s, edge_s, duration_s }: PlaybackState): ShownTime => ({
    flight,
    at_s,
    edge_s: Math.max(edge_s, duration_s),
  });
  const store = createStore<ShownTime>(() => timeOf(playback.store.getState()));
  playback.store.subscribe((state) => store.setState(timeOf(state)));
  return {
    store,
    seek: (at_s) => {
      if (store.getState().flight === null) {
        playback.openFlight(CURRENT, at_s);
      } else {
        playback.seek(at_s);
      }
    },
    open: (flight) => playback.openFlight(flight, 0),
  };
}
