import { useMemo } from "react";
import { AIRCRAFT, type Aircraft } from "../../../lib/aircraft";
import { COLOURINGS, type Colouring, type Range, rangeOf } from "../../../lib/track/trackColours";
import { useUnit } from "../../../readouts/useUnit";
import { usePart, useSettings } from "../../../store/hooks";
import { TRACK_LOG, useTracks } from "./trackLog";

/** The chosen style of the tracks, and the values that their colours stand for. */
export interface TrackChoices {
  readonly colouring: Colouring;
  readonly hasCurtain: boolean;
  readonly isShown: Readonly<Record<Aircraft, boolean>>;
  /** Round numbers in the shown unit; null while unknown. */
  readonly shown: Range | null;
  /** The same in metres or metres a second. */
  readonly range: Range | null;
  readonly unit: string;
}

export function useTrackLook(): TrackChoices {
  const trackLog = usePart(TRACK_LOG);
  const colouring = useSettings(
    ({ choices }) => COLOURINGS.find((name) => name === choices["map.track.colour"]) ?? "none",
  );
  const hasCurtain = useSettings(({ choices }) => choices["map.track.curtain"] !== "off");
  const flight = useSettings(({ choices }) => choices["map.track.flight"] !== "off");
  const hil = useSettings(({ choices }) => choices["map.track.hil"] !== "off");
  const summary = useTracks((tracks) => tracks.summary);
  const units = {
    height: useUnit("altitude", "m"),
    speed: useUnit("speed", "mPerS"),
    climb: useUnit("verticalSpeed", "mPerS"),
  };
  const unit = units[colouring === "none" ? "height" : colouring];
  // biome-ignore lint/correctness/useExhaustiveDependencies: the spread of the points changes with their summary
  return useMemo(() => {
    const isShown = { flight, hil };
    const tracks = AIRCRAFT.filter((name) => isShown[name]).map((name) => trackLog.points[name]);
    const shown = colouring === "none" ? null : rangeOf(colouring, tracks, unit.convert);
    const range = shown && { least: unit.revert(shown.least), most: unit.revert(shown.most) };
    return { colouring, hasCurtain, isShown, shown, range, unit: unit.label };
  }, [trackLog, colouring, hasCurtain, flight, hil, unit, summary]);
}
