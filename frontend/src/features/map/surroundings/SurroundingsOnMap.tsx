import { useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { AIRCRAFT } from "../../../lib/aircraft";
import { METRES_PER_FOOT } from "../../../lib/units";
import type { AircraftAround } from "../../../protocol/guards.gen";
import { useRoleBlocked } from "../../../requests/useRole";
import type { MeasuredPlace } from "../../../scene/tools/DistanceLine";
import { useConnection, useIsPast, usePart } from "../../../store/hooks";
import { useFlat } from "../scenes/useFlat";
import { useMapTools, useScreenTools } from "../scenes/useScreenTools";
import { chooseTool, MAP_TOOL, useMapTool } from "../tools/mapTool";
import { isSaved, MOST_CORNERS, SURROUNDINGS } from "./surroundings";
import { useReadSurroundings, useSurroundings } from "./useSurroundings";

/** The fence on the map that is shown, and the present track while it is warned of. */
export function SurroundingsOnMap() {
  useReadSurroundings();
  useFence();
  useWarnedTracks();
  return null;
}

function useFence(): void {
  const { edit } = usePart(SURROUNDINGS);
  const mapTool = usePart(MAP_TOOL);
  const flat = useFlat();
  const globe = useMapTools();
  const tools = useScreenTools();
  const corners = useSurroundings((state) => state.corners.present);
  const saved = useSurroundings(isSaved);
  const isPast = useIsPast();
  const isFixed = useRoleBlocked("operator") !== undefined || isPast;
  const isMarking = useMapTool(({ tool }) => tool === "fence") && !isFixed;
  // The fence of now was not that of then.
  const shown = useMemo(() => (isPast ? [] : corners), [isPast, corners]);
  useEffect(() => flat.scene?.fence.show(shown, saved), [flat.scene, shown, saved]);
  useEffect(() => {
    const border = shown.length > 2 ? [...shown, ...shown.slice(0, 1)] : shown;
    globe?.showFence(border.map((place) => ({ ...place, height_m: null, label: "" })));
  }, [globe, shown]);
  useEffect(() => {
    flat.scene?.fence.listen(isFixed ? null : (corner, to) => edit(corners.with(corner, to)));
    return () => flat.scene?.fence.listen(null);
  }, [flat.scene, isFixed, corners, edit]);
  useEffect(() => {
    if (!isMarking) return undefined;
    tools?.measure(({ latitude_deg, longitude_deg }) => {
      if (corners.length < MOST_CORNERS) edit([...corners, { latitude_deg, longitude_deg }]);
    });
    return () => tools?.measure(null);
  }, [tools, isMarking, corners, edit]);
  useEffect(() => {
    if (!isMarking) return undefined;
    const press = (event: KeyboardEvent): void => {
      const isTyping = event.target instanceof HTMLElement && event.target.matches("input, select, textarea");
      if (event.defaultPrevented || isTyping) return;
      if (event.key === "Escape") chooseTool(mapTool, "pick");
      else if (event.key === "Backspace") edit(corners.slice(0, -1));
      else return;
      event.preventDefault();
    };
    window.addEventListener("keydown", press, { capture: true });
    return () => window.removeEventListener("keydown", press, { capture: true });
  }, [isMarking, mapTool, corners, edit]);
}

function useWarnedTracks(): void {
  const { t } = useTranslation();
  const flat = useFlat();
  const globe = useMapTools();
  const around = useConnection(({ phase, status }) =>
    phase === "open" && status !== null ? status.surroundings : null,
  );
  const tracks = useMemo(() => {
    if (around === null) return NO_TRACKS;
    const warned = AIRCRAFT.map((aircraft) =>
      warnedTrack(around[aircraft], (what, seconds) => t(`mapAhead.${what}`, { seconds })),
    ).filter((track) => track.length > 0);
    return warned.length > 0 ? warned : NO_TRACKS;
  }, [around, t]);
  useEffect(() => flat.scene?.fence.warn(tracks), [flat.scene, tracks]);
  useEffect(() => globe?.showWarned(tracks[0] ?? []), [globe, tracks]);
}

/** Always the same one: the station speaks twice a second, and each new list would be drawn. */
const NO_TRACKS: ReadonlyArray<readonly MeasuredPlace[]> = [];

type What = NonNullable<AircraftAround["terrain"]>["what"];

/** The present track as far as what it leads to first; empty without a warning. */
export function warnedTrack(
  { path, terrain, fence }: AircraftAround,
  say: (what: What, seconds: number) => string,
): readonly MeasuredPlace[] {
  const first = [terrain, fence]
    .filter((threat) => threat !== null)
    .sort((one, other) => one.in_s - other.in_s)[0];
  if (first === undefined) {
    return [];
  }
  // The path's places are equally far apart in time; those before the end are drawn.
  const before = path.slice(0, Math.max(1, Math.ceil(first.in_s / PATH_STEP_S)));
  const end: MeasuredPlace = {
    latitude_deg: first.latitude_deg,
    longitude_deg: first.longitude_deg,
    height_m: first.altitude_ft * METRES_PER_FOOT,
    label: say(first.what, Math.round(first.in_s)),
  };
  return [...before.map((place) => ({ ...place, height_m: end.height_m, label: "" })), end];
}

/** The station sends every fifth half second of the track. */
const PATH_STEP_S = 2.5;
