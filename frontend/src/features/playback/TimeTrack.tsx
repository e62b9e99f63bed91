import type { TFunction } from "i18next";
import { type KeyboardEvent, type RefObject, useEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatDateTime, formatFlightTime } from "../../lib/moment";
import { usePart } from "../../store/hooks";
import { type BarView, showing, wholeFlight, xOf } from "./barGeometry";
import { LANES } from "./flightLanes";
import { CURRENT, PLAYBACK } from "./playbackRequests";
import { moment_s, type PlaybackState } from "./playbackState";
import { enterPast, runInPast, timeAction } from "./timeKeys";
import { useBarGestures } from "./useBarGestures";
import { useBarPicture, useSize } from "./useBarPicture";
import { useEdge_s, usePlayback } from "./usePlayback";

/** A press so near to the edge of the present means the present. */
const AT_EDGE_PX = 8;

interface Props {
  readonly onMark: () => void;
}

/** The bar itself: a slider over the flight, drawn under its handle. */
export function TimeTrack({ onMark }: Props) {
  const { t } = useTranslation();
  const playback = usePart(PLAYBACK);
  const bar = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const handle = useRef<HTMLSpanElement>(null);
  const flight = usePlayback((state) => state.flight);
  const edge_s = useEdge_s();
  const [zoom, setZoom] = useState<BarView | null>(null);
  const view = useMemo(() => zoom ?? wholeFlight(edge_s), [zoom, edge_s]);
  const size = useSize(bar);
  useBarPicture(canvas, size, view, edge_s);
  const isPast = flight !== null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: a zoom does not outlast the past in which it was made
  useEffect(() => () => setZoom(null), [isPast]);
  useHandle({ bar, handle, view, width: size.width, edge_s });
  useFollowing(zoom, setZoom, edge_s);

  const gestures = useBarGestures({
    bar,
    view,
    edge_s,
    onView: setZoom,
    onRelease: playback.settle,
    onMoment: (at_s) => {
      if (playback.store.getState().flight !== null) {
        playback.seek(at_s);
      } else if (edge_s > 0 && xOf(edge_s, view, size.width) - xOf(at_s, view, size.width) > AT_EDGE_PX) {
        playback.openFlight(CURRENT, at_s);
      }
    },
  });

  function onKeyDown(event: KeyboardEvent): void {
    const action = timeAction(event);
    if (action === null) {
      return;
    }
    if (action.do === "mark") {
      onMark();
    } else if (flight !== null ? !runInPast(playback, action) : !enterPast(playback, action, edge_s)) {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  return (
    <div
      ref={bar}
      className="time-track"
      role="slider"
      tabIndex={0}
      aria-label={t("time.bar")}
      aria-orientation="horizontal"
      aria-valuemin={0}
      aria-valuemax={edge_s}
      aria-valuenow={edge_s}
      onKeyDown={onKeyDown}
      {...gestures}
    >
      <canvas ref={canvas} className="time-canvas" />
      {isPast && <Legend />}
      <span ref={handle} className="time-handle" aria-hidden="true" />
    </div>
  );
}

/** What each row of marks is, in the row's own colour and in the order of the rows. Part of the slider's picture. */
function Legend() {
  const { t } = useTranslation();
  return (
    <span className="time-legend" aria-hidden="true">
      {LANES.map((lane) => (
        <span key={lane} data-lane={lane}>
          {t(`timeLane.${lane}`)}
        </span>
      ))}
    </span>
  );
}

interface HandleParts {
  readonly bar: RefObject<HTMLElement | null>;
  readonly handle: RefObject<HTMLElement | null>;
  readonly view: BarView;
  readonly width: number;
  readonly edge_s: number;
}

/** Descriptions for screen readers change at most this often. */
const SAID_EVERY_MS = 500;

/** Moves the handle and says where it is, without a render: a flight that plays moves it many times a second. */
function useHandle({ bar, handle, view, width, edge_s }: HandleParts): void {
  const { t } = useTranslation();
  const { store } = usePart(PLAYBACK);
  useEffect(() => {
    let said_ms = Number.NEGATIVE_INFINITY;
    const move = (): void => {
      const state = store.getState();
      const at_s = state.flight === null ? edge_s : state.at_s;
      const x = xOf(at_s, view, width);
      if (handle.current !== null) {
        handle.current.style.transform = `translateX(${x.toFixed(1)}px)`;
        handle.current.hidden = x < 0 || x > width;
      }
      const now_ms = performance.now();
      if (state.state === "playing" && now_ms - said_ms < SAID_EVERY_MS) {
        return;
      }
      said_ms = now_ms;
      const text = valueText(t, state, at_s);
      bar.current?.setAttribute("aria-valuenow", String(Math.round(at_s)));
      bar.current?.setAttribute("aria-valuetext", text);
    };
    move();
    return store.subscribe(move);
  }, [bar, handle, view, width, edge_s, store, t]);
}

function valueText(t: TFunction, state: PlaybackState, at_s: number): string {
  if (state.flight === null) {
    return t("time.valueNow", { time: formatFlightTime(at_s) });
  }
  const clock_s = moment_s(state);
  const clock = clock_s === null ? "" : formatDateTime(clock_s);
  return t("time.value", { time: formatFlightTime(at_s, 1), clock });
}

/** Keeps the moment that is shown in a view that somebody zoomed. */
function useFollowing(zoom: BarView | null, setZoom: (view: BarView) => void, edge_s: number): void {
  const { store } = usePart(PLAYBACK);
  useEffect(() => {
    if (zoom === null) {
      return undefined;
    }
    return store.subscribe(({ flight, at_s }, before) => {
      if (flight !== null && at_s !== before.at_s) {
        const next = showing(zoom, at_s, edge_s);
        if (next !== zoom) {
          setZoom(next);
        }
      }
    });
  }, [zoom, setZoom, edge_s, store]);
}
