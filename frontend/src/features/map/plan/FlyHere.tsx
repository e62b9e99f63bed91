import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import { type Afterwards, flownHere, target } from "../../../lib/flyHere";
import { formatHeading } from "../../../lib/format";
import { bearing_deg, distance_m, type Position } from "../../../lib/geodesy";
import { checkPlan } from "../../../lib/planCheck";
import { editPlan, MISSIONS } from "../../../missions/planDrafts";
import { SELECTION, selectThing } from "../../../missions/selection";
import { useIssueText } from "../../../missions/useIssueText";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { coordinate } from "../../../readouts/formats";
import { useUnit } from "../../../readouts/useUnit";
import { usePart, useTelemetry } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { Dialog } from "../../../ui/Dialog";
import { Notice } from "../../../ui/Notice";
import { NumberField } from "../../../ui/NumberField";
import { aircraftPlace, PLACE_TOPIC } from "../aircraft/aircraftPlace";
import { MAP_TOOL, useMapTool } from "../tools/mapTool";
import { flownRow, useFlyHereBlocked } from "./useFlyHere";
import { type MapPlan, useMapPlan } from "./useMapPlan";
import { useOpenPlan } from "./useOpenPlan";

/** Asks before the aircraft is sent to a place of the map. */
export function FlyHere() {
  const to = useMapTool(({ flyTo }) => flyTo);
  const tools = usePart(MAP_TOOL);
  const plans = { flight: useMapPlan("flight"), hil: useMapPlan("hil") };
  const open = useOpenPlan(plans.flight);
  return to === null ? null : (
    <Question opened={open} plans={plans} to={to} onClose={() => tools.setState({ flyTo: null })} />
  );
}

interface Props {
  /** The aircraft whose plan is open when it is asked: the question stays with it. */
  opened: Aircraft;
  plans: Readonly<Record<Aircraft, MapPlan>>;
  to: Position;
  onClose: () => void;
}

function Question({ opened, plans, to, onClose }: Props) {
  const [aircraft] = useState(opened);
  const plan = plans[aircraft];
  const { t } = useTranslation();
  const missions = usePart(MISSIONS);
  const selection = usePart(SELECTION);
  const issueText = useIssueText();
  const altitude = useUnit("altitude");
  const blocked = useFlyHereBlocked(plan);
  const row = flownRow(plan);
  const [altitude_ft, setAltitude_ft] = useState(() => target(plan.waypoints, row).altitude_ft);
  const { minimum, maximum } = PLAN_LIMITS.fields.altitude_ft;

  const ways = {
    goOn: flownHere(plan.waypoints, row, to, altitude_ft, "goOn"),
    stay: flownHere(plan.waypoints, row, to, altitude_ft, "stay"),
  };

  /** Why this way cannot be flown: the plan's first error with the new waypoint in it. */
  function fault(way: Afterwards): string | undefined {
    const plannedWay = ways[way];
    if (plannedWay === null) {
      return t("map.fly.unknown");
    }
    const error = checkPlan(plannedWay.waypoints, PLAN_LIMITS).find(({ level }) => level === "error");
    return error === undefined ? undefined : issueText(error);
  }

  function fly(way: Afterwards): void {
    const plannedWay = ways[way];
    if (plannedWay !== null) {
      editPlan(missions.plans, aircraft, plannedWay.waypoints);
      selectThing(selection, { kind: "waypoint", plan: aircraft, row: plannedWay.row });
      void missions.upload(aircraft, { control: `plan.upload.${aircraft}` }, plannedWay.row);
      onClose();
    }
  }

  return (
    <Dialog
      title={t("map.fly.title")}
      description={t("map.fly.text", {
        plan: t(`planName.${aircraft}`),
        place: `${coordinate(to.latitude_deg)}${t("unit.deg")} ${coordinate(to.longitude_deg)}${t("unit.deg")}`,
      })}
      onClose={onClose}
      actions={
        <>
          <Button onPress={onClose}>{t("dialog.cancel")}</Button>
          <Button takesFields onPress={() => fly("stay")} disabledReason={blocked ?? fault("stay")}>
            {t("map.fly.stay")}
          </Button>
          <Button
            takesFields
            variant="primary"
            onPress={() => fly("goOn")}
            disabledReason={blocked ?? fault("goOn")}
          >
            {row === null ? t("map.fly.goOnNone") : t("map.fly.goOn", { number: row + 1 })}
          </Button>
        </>
      }
    >
      <Away aircraft={aircraft} to={to} />
      <NumberField
        label={t("plans.altitude")}
        value={altitude.convert(altitude_ft)}
        minimum={altitude.convert(minimum)}
        maximum={altitude.convert(maximum)}
        step={10}
        format={(value) => value.toFixed(altitude.digits)}
        unit={altitude.label}
        onCommit={(shown) => setAltitude_ft(altitude.revert(shown))}
      />
      {plan.state !== "same" && plan.waypoints.length > 0 && (
        <Notice level="warning">{t("map.fly.unsent")}</Notice>
      )}
      <p>{t("map.fly.how")}</p>
    </Dialog>
  );
}

/** How far it is from where the aircraft is now, as far as that is live. */
function Away({ aircraft, to }: { aircraft: Aircraft; to: Position }) {
  const { t } = useTranslation();
  const distance = useUnit("distance");
  const text = useTelemetry((telemetry, now_ms) => {
    const from = aircraftPlace(telemetry, aircraft);
    return from === null || telemetry.state(PLACE_TOPIC[aircraft], now_ms) !== "live"
      ? t("map.fly.nowhere")
      : t("map.fly.away", {
          distance: `${distance.format(distance_m(from, to))} ${distance.label}`,
          bearing: formatHeading(bearing_deg(from, to), 0) ?? t("words.dash"),
        });
  });
  return <p>{text}</p>;
}
