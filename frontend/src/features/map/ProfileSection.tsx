import { useTranslation } from "react-i18next";
import { FoldingPanel } from "./panels/FoldingPanel";
import { useMapPlan } from "./plan/useMapPlan";
import { useOpenPlan } from "./plan/useOpenPlan";
import { PlanProfile } from "./profile/PlanProfile";

/** The profile of the plan that is open. */
export function ProfileSection() {
  const { t } = useTranslation();
  const open = useOpenPlan(useMapPlan("flight"));
  return (
    <FoldingPanel name="profile" title={t("map.profile.title")} isFoldedFirst>
      <PlanProfile aircraft={open} />
    </FoldingPanel>
  );
}
