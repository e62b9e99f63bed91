import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { useUnit } from "../../../readouts/useUnit";
import { FoldingPanel } from "../panels/FoldingPanel";
import { useMapPlan } from "../plan/useMapPlan";
import { ProfilePicture } from "./ProfilePicture";
import { useProfile } from "./useProfile";
import "./profile.css";

/** As wide as the flight view's map is, beside the height of the picture. */
const WIDTH = 1500;

/** Where it is open at first: a window with room for more than one needs at once. */
const LARGE = "(width >= 120rem)";

/** The flown plan from the side, along the bottom of the flight view. */
export function FlightProfile({ plan }: { readonly plan: Aircraft }) {
  const { t } = useTranslation();
  return (
    <FoldingPanel
      name="flightProfile"
      title={t("map.profile.title")}
      className="fly-profile"
      isFoldedFirst={!(typeof window.matchMedia === "function" && window.matchMedia(LARGE).matches)}
    >
      <Picture plan={plan} />
    </FoldingPanel>
  );
}

function Picture({ plan }: { readonly plan: Aircraft }) {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const { waypoints, flownTo } = useMapPlan(plan);
  const profile = useProfile(waypoints);
  return waypoints.length < 2 ? (
    <p className="map-plan-hint">{t("map.profile.none")}</p>
  ) : (
    <ProfilePicture
      label={t("map.profile.picture", { count: waypoints.length })}
      profile={profile}
      waypoints={waypoints}
      formatAltitude={(altitude_ft) => `${altitude.convert(altitude_ft).toFixed(0)} ${altitude.label}`}
      selected={flownTo}
      width={WIDTH}
    />
  );
}
