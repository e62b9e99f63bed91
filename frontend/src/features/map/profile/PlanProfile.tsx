import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { SELECTION, selectThing } from "../../../missions/selection";
import { useUnit } from "../../../readouts/useUnit";
import { usePage, usePart } from "../../../store/hooks";
import { choose } from "../../../store/settings";
import { NumberField } from "../../../ui/NumberField";
import { useMapPlan } from "../plan/useMapPlan";
import { useSelectedRows } from "../plan/useSelectedRows";
import { ProfilePicture } from "./ProfilePicture";
import { CLEARANCE_CHOICE, type Profile, useProfile } from "./useProfile";
import { WindAndTime } from "./WindAndTime";
import "./profile.css";

/** A plan's altitude over the ground, with its clearance, and how long its legs take in the wind. */
export function PlanProfile({ aircraft }: { aircraft: Aircraft }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const selection = usePart(SELECTION);
  const altitude = useUnit("altitude");
  const { waypoints } = useMapPlan(aircraft);
  const profile = useProfile(waypoints);
  const [selected = null] = useSelectedRows(aircraft);
  const { wanted_ft } = profile;
  if (waypoints.length < 2) {
    return <p className="map-plan-hint">{t("map.profile.none")}</p>;
  }
  return (
    <div className="map-profile">
      <ProfilePicture
        label={t("map.profile.picture", { count: waypoints.length })}
        profile={profile}
        waypoints={waypoints}
        formatAltitude={(altitude_ft) => `${altitude.convert(altitude_ft).toFixed(0)} ${altitude.label}`}
        selected={selected}
      />
      <Warnings aircraft={aircraft} profile={profile} />
      <div className="map-profile-fields">
        <NumberField
          label={t("map.profile.wanted")}
          value={altitude.convert(wanted_ft)}
          minimum={0}
          maximum={altitude.convert(5000)}
          step={50}
          format={(value) => value.toFixed(0)}
          unit={altitude.label}
          onCommit={(shown) => choose(settings, CLEARANCE_CHOICE, String(altitude.revert(shown)))}
        />
        <WindAndTime
          aircraft={aircraft}
          waypoints={waypoints}
          onGo={(row) => selectThing(selection, { kind: "waypoint", plan: aircraft, row })}
        />
      </div>
    </div>
  );
}

function Warnings({ aircraft, profile }: { aircraft: Aircraft; profile: Profile }) {
  const { t } = useTranslation();
  const selection = usePart(SELECTION);
  const altitude = useUnit("altitude");
  const { clearance, hasTerrain, hasUnknownDatum, wanted_ft } = profile;
  if (clearance === null) {
    return <p className="map-plan-hint">{t("map.profile.asking")}</p>;
  }
  const written = (altitude_ft: number): string => `${altitude.format(altitude_ft)} ${altitude.label}`;
  const { least, low, unknown } = clearance;
  return (
    <div className="map-plan-issues">
      <p role="status">
        {least === null
          ? t(hasTerrain ? "map.profile.unknownHere" : "map.profile.unknown")
          : t("map.profile.least", { height: written(least.clearance_ft), number: least.row + 1 })}
      </p>
      {least !== null && hasUnknownDatum && <p className="map-profile-part">{t("map.layers.datumOff")}</p>}
      {least !== null && unknown > 0 && (
        <p className="map-profile-part">
          {t("map.profile.part", { percent: Math.max(1, Math.round(100 * unknown)) })}
        </p>
      )}
      <ul>
        {low.map(({ row, clearance_ft }) => (
          <li key={row} data-level={clearance_ft < 0 ? "error" : "warning"}>
            <button
              type="button"
              onClick={() => selectThing(selection, { kind: "waypoint", plan: aircraft, row })}
            >
              {clearance_ft < 0
                ? t("map.profile.under", { number: row + 1, height: written(-clearance_ft) })
                : t("map.profile.low", {
                    number: row + 1,
                    height: written(clearance_ft),
                    wanted: written(wanted_ft),
                  })}
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}
