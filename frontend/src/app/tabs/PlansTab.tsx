import { PlanMap } from "../../features/map/PlanMap";
import { PlansView } from "../../features/plans/PlansView";

/** "Planes de vuelo", with the map of each plan in its place. */
export function PlansTab() {
  return <PlansView map={(plan) => <PlanMap plan={plan} />} />;
}
