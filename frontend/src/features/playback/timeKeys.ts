import { CURRENT, type Playback } from "./playbackRequests";
import { nextRate } from "./playbackState";

/** What a key does to the time that is shown. */
export type TimeAction =
  | { readonly do: "now" | "toggle" | "start" | "end" | "mark" }
  | { readonly do: "frame" | "event" | "rate"; readonly direction: 1 | -1 }
  | { readonly do: "seconds"; readonly by_s: number };

type KeyPress = Pick<KeyboardEvent, "key" | "shiftKey" | "ctrlKey" | "altKey" | "metaKey">;

const SECOND_S = 1;
const TEN_SECONDS_S = 10;

/** The keys of the time bar, as the help sheet lists them: names of keys, and a key of the catalogue. */
export const TIME_KEYS: ReadonlyArray<{
  readonly keys: readonly string[];
  readonly words: "now" | "toggle" | "frame" | "second" | "tenSeconds" | "event" | "ends" | "rate" | "mark";
}> = [
  { keys: ["Esc"], words: "now" },
  { keys: ["Space"], words: "toggle" },
  { keys: ["←", "→"], words: "frame" },
  { keys: ["Shift", "←", "→"], words: "second" },
  { keys: ["Ctrl", "←", "→"], words: "tenSeconds" },
  { keys: ["PgUp", "PgDn"], words: "event" },
  { keys: ["Home", "End"], words: "ends" },
  { keys: ["Shift", "↑", "↓"], words: "rate" },
  { keys: ["Shift", "M"], words: "mark" },
];

/** The keys that do one thing, whatever else is held; Ctrl with them belongs to the browser. */
const PLAIN: Readonly<Record<string, TimeAction>> = {
  Escape: { do: "now" },
  " ": { do: "toggle" },
  PageUp: { do: "event", direction: 1 },
  PageDown: { do: "event", direction: -1 },
  Home: { do: "start" },
  End: { do: "end" },
  ArrowUp: { do: "rate", direction: 1 },
  ArrowDown: { do: "rate", direction: -1 },
  M: { do: "mark" },
};

/** What this key does; null if it is none of the time's. */
export function timeAction({ key, shiftKey, ctrlKey, altKey, metaKey }: KeyPress): TimeAction | null {
  if (altKey || metaKey) {
    return null;
  }
  if (key === "ArrowLeft" || key === "ArrowRight") {
    return arrow(key === "ArrowRight" ? 1 : -1, shiftKey, ctrlKey);
  }
  return ctrlKey ? null : (PLAIN[key] ?? null);
}

function arrow(direction: 1 | -1, isShift: boolean, isCtrl: boolean): TimeAction {
  if (isCtrl) {
    return { do: "seconds", by_s: direction * TEN_SECONDS_S };
  }
  return isShift ? { do: "seconds", by_s: direction * SECOND_S } : { do: "frame", direction };
}

/** Does it in the past. False if the action is not of the playback: the mark needs its words first. */
export function runInPast(playback: Playback, action: TimeAction): boolean {
  const { state, at_s, rate, edge_s } = playback.store.getState();
  switch (action.do) {
    case "now":
      playback.now();
      return true;
    case "toggle":
      (state === "playing" ? playback.pause : playback.play)();
      return true;
    case "frame":
      playback.step(action.direction);
      return true;
    case "seconds":
      playback.seek(at_s + action.by_s);
      return true;
    case "event":
      playback.jump(action.direction);
      return true;
    case "rate":
      playback.setRate(nextRate(rate, action.direction));
      return true;
    case "start":
      playback.seek(0);
      return true;
    case "end":
      playback.seek(edge_s);
      return true;
    case "mark":
      return false;
  }
}

/** Does it in the present, on the bar: only what goes back enters the past of the flight that is being recorded. */
export function enterPast(playback: Playback, action: TimeAction, edge_s: number): boolean {
  const back_s =
    action.do === "frame" && action.direction === -1
      ? SECOND_S
      : action.do === "seconds" && action.by_s < 0
        ? -action.by_s
        : null;
  if (back_s === null && action.do !== "start") {
    return false;
  }
  playback.openFlight(CURRENT, back_s === null ? 0 : edge_s - back_s);
  return true;
}
