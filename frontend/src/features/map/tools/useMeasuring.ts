import { useCallback, useEffect, useMemo } from "react";
import { formatHeading } from "../../../lib/format";
import { bearing_deg, distance_m } from "../../../lib/geodesy";
import { type Unit, useUnit } from "../../../readouts/useUnit";
import type { GroundPlace } from "../../../scene/legs/target";
import { usePart } from "../../../store/hooks";
import { useScreenTools } from "../scenes/useScreenTools";
import { chooseTool, MAP_TOOL, useMapTool } from "./mapTool";

interface Leg {
  readonly distance_m: number;
  readonly bearing_deg: number | null;
  readonly total_m: number;
}

/** The legs from each point to the next, with the sum so far. */
export function measuredLegs(places: readonly GroundPlace[]): readonly Leg[] {
  let total_m = 0;
  return places.slice(1).map((to, index) => {
    const from = places[index] ?? to;
    const length_m = distance_m(from, to);
    total_m += length_m;
    return { distance_m: length_m, bearing_deg: bearing_deg(from, to), total_m };
  });
}

interface Measure {
  readonly tools: ReturnType<typeof useScreenTools>;
  readonly distance: Unit;
  readonly isOn: boolean;
  readonly setOn: (on: boolean) => void;
  readonly places: readonly GroundPlace[];
  readonly setPlaces: (change: (before: readonly GroundPlace[]) => readonly GroundPlace[]) => void;
  readonly legs: readonly Leg[];
}

/** The distance tool of the map that is shown: takes its points, draws its line, hears its keys. */
export function useMeasuring(): Measure {
  const tools = useScreenTools();
  const distance = useUnit("distance");
  const mapTool = usePart(MAP_TOOL);
  const isOn = useMapTool(({ tool }) => tool === "measure");
  const places = useMapTool(({ measured }) => measured);
  const setOn = useCallback((on: boolean) => chooseTool(mapTool, on ? "measure" : "pick"), [mapTool]);
  const setPlaces = useCallback(
    (change: (before: readonly GroundPlace[]) => readonly GroundPlace[]) =>
      mapTool.setState(({ measured }) => ({ measured: change(measured) })),
    [mapTool],
  );
  const legs = useMemo(() => measuredLegs(places), [places]);

  useEffect(() => {
    if (!isOn) return undefined;
    tools?.measure((place) => setPlaces((before) => [...before, place]));
    return () => tools?.measure(null);
  }, [tools, isOn, setPlaces]);
  useEffect(() => {
    tools?.showDistance(
      places.map((place, index) => {
        const leg = legs[index - 1];
        const bearing = leg === undefined ? null : formatHeading(leg.bearing_deg, 0);
        const along = leg === undefined ? "" : `${distance.format(leg.total_m)} ${distance.label}`;
        return { ...place, label: bearing === null ? along : `${along} · ${bearing}°` };
      }),
    );
  }, [tools, places, legs, distance]);
  useEffect(() => {
    if (!isOn) return undefined;
    const press = (event: KeyboardEvent): void => {
      const isTyping = event.target instanceof HTMLElement && event.target.matches("input, select, textarea");
      if (event.defaultPrevented || isTyping) return;
      if (event.key === "Escape") setOn(false);
      else if (event.key === "Backspace") setPlaces((before) => before.slice(0, -1));
      else return;
      event.preventDefault();
    };
    window.addEventListener("keydown", press, { capture: true });
    return () => window.removeEventListener("keydown", press, { capture: true });
  }, [isOn, setOn, setPlaces]);
  return { tools, distance, isOn, setOn, places, setPlaces, legs };
}
