import { useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { Aircraft } from "../../../lib/aircraft";
import { unsentOf, type Waypoint } from "../../../lib/plan";
import { carried } from "../../../lib/planEdit";
import { useFreshLineLaw, useTurnBank } from "../../../missions/lineLaw";
import { editPlan, MISSIONS } from "../../../missions/planDrafts";
import { SELECTION, useMapThing } from "../../../missions/selection";
import { useUnit } from "../../../readouts/useUnit";
import type { DrawnPlan } from "../../../scene/legs/shape";
import type { PlanScene } from "../../../scene/plan/PlanScene";
import { usePage, usePart } from "../../../store/hooks";
import { aircraftPlace } from "../aircraft/aircraftPlace";
import { useHome } from "../aircraft/useHome";
import { useFlat } from "../scenes/useFlat";
import { usePlanLayer } from "../scenes/useScreenTools";
import { useMapTool } from "../tools/mapTool";
import type { MapPlan } from "./useMapPlan";
import { usePlanHands } from "./usePlanHands";

/** A waypoint that is being dragged, and where it is now. */
export interface HeldWaypoint {
  readonly plan: Aircraft;
  readonly row: number;
  readonly to: Pick<Waypoint, "latitude_deg" | "longitude_deg" | "altitude_ft">;
}

const NONE: readonly number[] = [];

/** Shows the plans on the globe or the flat map, and applies clicks and drags to them. */
export function usePlanScene(
  plans: Readonly<Record<Aircraft, MapPlan>>,
  isShown: Readonly<Record<Aircraft, boolean>>,
  open: Aircraft,
  onHold: (held: HeldWaypoint | null) => void,
): void {
  const page = usePage();
  useFreshLineLaw();
  const onGlobe = usePlanLayer();
  const flat = useFlat();
  const scene: Pick<PlanScene, "show" | "showHome" | "listen"> | null = flat.isShown
    ? (flat.scene?.plans ?? null)
    : onGlobe;
  const aiming: Pick<PlanScene, "aim"> | null = flat.isShown ? flat.scene : onGlobe;
  const isAdding = useMapTool(({ tool }) => tool === "add");
  const hands = usePlanHands(plans, open);
  const { flight, hil } = plans;
  const drawnFlight = useDrawn("flight", flight, isShown.flight);
  const drawnHil = useDrawn("hil", hil, isShown.hil);
  const { t } = useTranslation();
  const home = useHome();
  const homeLabel = t("map.plan.home");

  useEffect(() => scene?.show("flight", drawnFlight), [scene, drawnFlight]);
  useEffect(() => scene?.show("hil", drawnHil), [scene, drawnHil]);
  useEffect(
    () =>
      scene?.showHome({
        latitude_deg: home.latitude_deg,
        longitude_deg: home.longitude_deg,
        label: homeLabel,
      }),
    [scene, home.latitude_deg, home.longitude_deg, homeLabel],
  );
  useEffect(() => aiming?.aim(isAdding), [aiming, isAdding]);
  useEffect(() => {
    scene?.listen(
      {
        ...hands,
        drag: onHold,
        drop: (plan, row, to) => {
          const { waypoints } = plan === "flight" ? flight : hil;
          const { rows } = page.parts.get(SELECTION).getState();
          editPlan(page.parts.get(MISSIONS).plans, plan, carried(waypoints, row, to, rows));
        },
      },
      (plan) => aircraftPlace(page.telemetry, plan),
    );
    return () => scene?.listen(null);
  }, [scene, page, onHold, hands, flight, hil]);
}

/** A plan as it is drawn; the same object while nothing of it changes. */
function useDrawn(plan: Aircraft, { waypoints, onBoard, state, flownTo, ending }: MapPlan, isShown: boolean) {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const turnBank_deg = useTurnBank();
  const thing = useMapThing();
  const selected = thing?.kind === "waypoint" && thing.plan === plan ? thing.row : null;
  const rows = useStore(usePart(SELECTION), (now) => now.rows);
  const chosen = selected === null ? NONE : rows;
  return useMemo((): DrawnPlan | null => {
    const board = state === "differs" ? onBoard : null;
    const last = waypoints.length - 1;
    return isShown && waypoints.length > 0
      ? {
          waypoints,
          board,
          unsent: unsentOf(waypoints, onBoard),
          active: onBoard !== null && flownTo !== null && flownTo < onBoard.length ? flownTo : null,
          loops: ending === "loop" && board === null,
          turnBank_deg,
          selected,
          chosen,
          label: (waypoint, row) => {
            const height = `${row + 1} · ${altitude.format(waypoint.altitude_ft)} ${altitude.label}`;
            return row === last && ending === "hold" ? `${height} · ${t("map.plan.holds")}` : height;
          },
        }
      : null;
  }, [t, altitude, waypoints, onBoard, state, flownTo, ending, turnBank_deg, selected, chosen, isShown]);
}
