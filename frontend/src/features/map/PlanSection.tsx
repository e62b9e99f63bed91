import { useCallback, useState } from "react";
import { useTranslation } from "react-i18next";
import { AIRCRAFT, type Aircraft } from "../../lib/aircraft";
import { legsOf } from "../../lib/plan";
import { useTurnBank } from "../../missions/lineLaw";
import { SELECTION, selectThing, useMapThing } from "../../missions/selection";
import { useIssueText } from "../../missions/useIssueText";
import { useUnit } from "../../readouts/useUnit";
import { usePage, usePart, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Checkbox } from "../../ui/Checkbox";
import { EditScope } from "../../ui/openEdits";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { Select } from "../../ui/Select";
import { FoldingPanel } from "./panels/FoldingPanel";
import { PlanTransfer } from "./plan/PlanTransfer";
import { type MapPlan, useMapPlan } from "./plan/useMapPlan";
import { useOpenPlan } from "./plan/useOpenPlan";
import { type HeldWaypoint, usePlanScene } from "./plan/usePlanScene";
import { WaypointEditor } from "./plan/WaypointEditor";
import "./plan/map-plan.css";

/** The flight plans on the globe: what the board has, what is edited here, and the waypoint that is chosen. */
export function PlanSection() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const selection = usePart(SELECTION);
  const plans = { flight: useMapPlan("flight"), hil: useMapPlan("hil") };
  const isShown = {
    flight: useSettings(({ choices }) => choices["map.plan.flight"] !== "off"),
    hil: useSettings(({ choices }) => choices["map.plan.hil"] !== "off"),
  };
  const thing = useMapThing();
  const [held, setHeld] = useState<HeldWaypoint | null>(null);
  const onHold = useCallback((now: HeldWaypoint | null) => setHeld(now), []);
  const open = useOpenPlan(plans.flight);
  usePlanScene(plans, isShown, open, onHold);

  const plan = plans[open];
  const row =
    thing?.kind === "waypoint" && thing.plan === open && thing.row < plan.waypoints.length ? thing.row : null;

  return (
    <FoldingPanel name="plan" title={t("map.plan.title")} className="map-plan">
      <SegmentedSwitch
        label={t("map.plan.which")}
        hideLabel
        options={AIRCRAFT.map((value) => ({
          value,
          label: t(`map.plan.${value}`),
        }))}
        value={open}
        onChange={(next) => {
          choose(settings, "map.plan.open", next);
          if (thing?.kind === "waypoint") selectThing(selection, null);
        }}
      />
      <Checkbox
        label={open === "flight" ? t("map.plan.showFlight") : t("map.plan.showHil")}
        checked={isShown[open]}
        onChange={(isOn) => choose(settings, `map.plan.${open}`, isOn ? "on" : "off")}
      />
      <PlanState plan={plan} />
      <EditScope>
        <PlanTransfer aircraft={open} plan={plan} row={row} />
        <WaypointChoice aircraft={open} plan={plan} row={row} />
        {plan.isFixed && <p className="map-plan-state">{t("plans.fixed")}</p>}
        {row !== null && !plan.isFixed && (
          <WaypointEditor
            aircraft={open}
            waypoints={plan.waypoints}
            row={row}
            held={held?.plan === open && held.row === row ? held.to : null}
          />
        )}
      </EditScope>
      <Issues plan={plan} onGo={(at) => selectThing(selection, { kind: "waypoint", plan: open, row: at })} />
    </FoldingPanel>
  );
}

/** Whether the board has the shown plan, where it flies to, and what it does at the end. */
function PlanState({ plan }: { plan: MapPlan }) {
  const { t } = useTranslation();
  const distance = useUnit("distance");
  const turnBank_deg = useTurnBank();
  const { waypoints, state, flownTo, ending } = plan;
  const total_m = legsOf(waypoints).reduce((sum, leg) => sum + leg.distance_m, 0);
  return (
    <div className="map-plan-state">
      <p role="status" data-state={state}>
        {t(`planState.${state}`)}
      </p>
      {waypoints.length > 0 && (
        <p>
          {t("plans.total", {
            distance: `${distance.format(total_m) ?? t("words.dash")} ${distance.label}`,
            count: waypoints.length,
          })}
        </p>
      )}
      <p>{flownTo === null ? t("plans.flownToNone") : t("plans.flownTo", { number: flownTo + 1 })}</p>
      {turnBank_deg !== null && <p>{t("map.plan.turns", { bank: turnBank_deg })}</p>}
      {ending !== null && <p>{ending === "loop" ? t("map.plan.endsLoop") : t("map.plan.endsHold")}</p>}
    </div>
  );
}

function WaypointChoice({ aircraft, plan, row }: { aircraft: Aircraft; plan: MapPlan; row: number | null }) {
  const { t } = useTranslation();
  const selection = usePart(SELECTION);
  const altitude = useUnit("altitude");
  return (
    <Select
      label={t("map.plan.waypoint")}
      placeholder={t("map.plan.waypointNone")}
      value={row === null ? null : String(row)}
      onChange={(value) => selectThing(selection, { kind: "waypoint", plan: aircraft, row: Number(value) })}
      options={plan.waypoints.map(({ altitude_ft }, index) => ({
        value: String(index),
        label: `${index + 1} · ${altitude.format(altitude_ft) ?? t("words.dash")} ${altitude.label}`,
      }))}
      disabledReason={plan.waypoints.length === 0 ? t("map.plan.none") : undefined}
    />
  );
}

function Issues({ plan, onGo }: { plan: MapPlan; onGo: (row: number) => void }) {
  const text = useIssueText();
  const { t } = useTranslation();
  const { issues, waypoints } = plan;
  if (waypoints.length === 0) {
    return null;
  }
  const sorted = [...issues].sort(
    (one, other) => Number(one.level !== "error") - Number(other.level !== "error"),
  );
  return (
    <div className="map-plan-issues">
      <p role="status">
        {issues.length === 0 ? t("plans.noIssues") : t("map.plan.issues", { count: issues.length })}
      </p>
      <ul>
        {sorted.map((issue) => (
          <li key={`${issue.code} ${issue.row} ${issue.field}`} data-level={issue.level}>
            {issue.row === null ? (
              text(issue)
            ) : (
              <button type="button" onClick={() => issue.row !== null && onGo(issue.row)}>
                {text(issue)}
              </button>
            )}
          </li>
        ))}
      </ul>
    </div>
  );
}
