import { useEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import type { FlatScene } from "../../scene/flat/FlatScene";
import { FoldingPanel } from "./FoldingPanel";
import { FlatMap } from "./flat/FlatMap";
import { FlatContext } from "./flat/useFlat";
import { Attribution } from "./layers/Attribution";
import { FlyHere } from "./plan/FlyHere";
import { useMapPlan } from "./plan/useMapPlan";
import { OpenPlanContext } from "./plan/useOpenPlan";
import { usePlanScene } from "./plan/usePlanScene";
import { PlanProfile } from "./profile/PlanProfile";
import { EditBar } from "./tools/EditBar";
import { MapKeys } from "./tools/MapKeys";
import { MapMenu } from "./tools/MapMenu";
import { Measuring } from "./tools/Measuring";
import "./map.css";

/** The map of one plan, beside its table: the same map, tools, menu and keys as in the map's own tab. */
export function PlanMap({ plan }: { plan: Aircraft }) {
  const { t } = useTranslation();
  const [scene, setScene] = useState<FlatScene | null>(null);
  const flat = useMemo(() => ({ isShown: true, scene }), [scene]);
  return (
    <OpenPlanContext value={plan}>
      <FlatContext value={flat}>
        <Shown plan={plan} scene={scene} onScene={setScene} />
        <FoldingPanel name="planProfile" title={t("map.profile.title")}>
          <PlanProfile aircraft={plan} />
        </FoldingPanel>
      </FlatContext>
    </OpenPlanContext>
  );
}

interface ShownProps {
  plan: Aircraft;
  scene: FlatScene | null;
  onScene: (scene: FlatScene | null) => void;
}

function Shown({ plan, scene, onScene }: ShownProps) {
  const { t } = useTranslation();
  const picture = useRef<HTMLElement>(null);
  const plans = { flight: useMapPlan("flight"), hil: useMapPlan("hil") };
  const { waypoints } = plans[plan];
  const isShown = useMemo(() => ({ flight: plan === "flight", hil: plan === "hil" }), [plan]);
  usePlanScene(plans, isShown, plan, ignore);
  const isEmpty = waypoints.length === 0;
  // All of the plan when there is one, and not with each edit: the map stays where a person has put it.
  // biome-ignore lint/correctness/useExhaustiveDependencies: only for another scene, plan, or the first waypoints
  useEffect(() => scene?.lookAt(waypoints), [scene, plan, isEmpty]);
  return (
    <section ref={picture} className="map-scene map-beside" aria-label={t("map.edit.planMap")}>
      <FlatMap onScene={onScene} followChoice="plans.map.follow" />
      <div className="map-over">
        <EditBar />
      </div>
      <Measuring />
      <MapKeys picture={picture} />
      <MapMenu />
      <FlyHere />
      <Attribution />
    </section>
  );
}

function ignore(): void {
  // A waypoint that is pulled has no number fields here: the table shows it when it is put down.
}
