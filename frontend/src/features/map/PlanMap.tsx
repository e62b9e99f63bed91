import { type ComponentProps, type ReactNode, useEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import type { Waypoint } from "../../lib/plan";
import type { FlatScene } from "../../scene/flat/FlatScene";
import { EditBar } from "./edit/EditBar";
import { MapKeys } from "./edit/MapKeys";
import { MapMenu } from "./edit/MapMenu";
import { FlatMap } from "./flat/FlatMap";
import { Attribution } from "./layers/Attribution";
import { FoldingPanel } from "./panels/FoldingPanel";
import { FlyHere } from "./plan/FlyHere";
import { TargetDialog } from "./plan/TargetDialog";
import { useMapPlan } from "./plan/useMapPlan";
import { OpenPlanContext } from "./plan/useOpenPlan";
import { usePlanScene } from "./plan/usePlanScene";
import { PlanHazards } from "./profile/PlanHazards";
import { PlanProfile } from "./profile/PlanProfile";
import { FlatContext, FOLLOW_CHOICE } from "./scenes/useFlat";
import { SurroundingsOnMap } from "./surroundings/SurroundingsOnMap";
import { ThingCard } from "./ThingCard";
import { useMeasuring } from "./tools/useMeasuring";
import "./map.css";

/** The map of one plan, beside its table: the same map, tools, menu and keys as in the map's own tab. */
export function PlanMap({ plan }: { plan: Aircraft }) {
  const { t } = useTranslation();
  const [scene, setScene] = useState<FlatScene | null>(null);
  const flat = useMemo(() => ({ isShown: true, scene }), [scene]);
  return (
    <OpenPlanContext value={plan}>
      <FlatContext value={flat}>
        <Shown
          plan={plan}
          scene={scene}
          onScene={setScene}
          followChoice="plans.map.follow"
          over={<EditBar />}
        />
        <FoldingPanel name="planProfile" title={t("map.profile.title")}>
          <PlanProfile aircraft={plan} />
        </FoldingPanel>
      </FlatContext>
    </OpenPlanContext>
  );
}

/** The map of the flight view: it follows the aircraft, and what is pressed on it is shown over it. */
export function FlightMap({ plan }: { plan: Aircraft }) {
  const [scene, setScene] = useState<FlatScene | null>(null);
  const flat = useMemo(() => ({ isShown: true, scene }), [scene]);
  return (
    <OpenPlanContext value={plan}>
      <FlatContext value={flat}>
        <Shown
          plan={plan}
          scene={scene}
          onScene={setScene}
          followChoice={FOLLOW_CHOICE}
          only={plan}
          over={<ThingCard />}
        />
        <TargetDialog plan={plan} />
      </FlatContext>
    </OpenPlanContext>
  );
}

interface ShownProps {
  plan: Aircraft;
  /** The setting that stores whether it follows the aircraft. */
  followChoice: NonNullable<ComponentProps<typeof FlatMap>["followChoice"]>;
  only?: Aircraft | undefined;
  /** What stands over the picture. */
  over: ReactNode;
  scene: FlatScene | null;
  onScene: (scene: FlatScene | null) => void;
}

function Shown({ plan, scene, onScene, followChoice, only, over }: ShownProps) {
  const { t } = useTranslation();
  const picture = useRef<HTMLElement>(null);
  const plans = { flight: useMapPlan("flight"), hil: useMapPlan("hil") };
  const { waypoints } = plans[plan];
  const isShown = useMemo(() => ({ flight: plan === "flight", hil: plan === "hil" }), [plan]);
  usePlanScene(plans, isShown, plan, ignore);
  useFirstLook(scene, plan, waypoints);
  return (
    <section ref={picture} className="map-scene map-beside" aria-label={t("map.edit.planMap")}>
      <FlatMap onScene={onScene} followChoice={followChoice} only={only} />
      <div className="map-over">{over}</div>
      <Measuring />
      <SurroundingsOnMap />
      <PlanHazards plan={plan} />
      <MapKeys picture={picture} />
      <MapMenu />
      <FlyHere />
      <Attribution />
    </section>
  );
}

/**
 * Shows all of a plan when there is one: at first, and where it came whole. One that is drawn point by point stays where
 * it is, and so does the map.
 */
function useFirstLook(scene: FlatScene | null, plan: Aircraft, waypoints: readonly Waypoint[]): void {
  const looked = useRef<{ readonly scene: FlatScene; readonly plan: Aircraft; readonly count: number }>(null);
  useEffect(() => {
    if (scene !== null) {
      const before = looked.current;
      const isSame = before?.scene === scene && before.plan === plan;
      if (!isSame || (before.count === 0 && waypoints.length > 1)) {
        scene.lookAt(waypoints);
      }
      looked.current = { scene, plan, count: waypoints.length };
    }
  }, [scene, plan, waypoints]);
}

function ignore(): void {
  // A waypoint that is pulled has no number fields here: the table shows it when it is put down.
}

/** The distance tool where there is no panel for it. */
export function Measuring() {
  useMeasuring();
  return null;
}
