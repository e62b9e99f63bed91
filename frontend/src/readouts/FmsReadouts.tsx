import "./readouts.css";
import type { ParseKeys } from "i18next";
import { ChevronLeft, ChevronRight } from "lucide-react";
import { useTranslation } from "react-i18next";
import type { CommandName } from "../protocol/messages.gen";
import type { NumberField } from "../protocol/topics";
import { CommandButton } from "../requests/CommandButton";
import { useTelemetry } from "../store/hooks";
import type { ReadoutRow } from "./LiveReadout";
import { COUNT, HEADING } from "./notations";
import { ReadoutTable } from "./ReadoutTable";

interface Plan {
  readonly previous: CommandName;
  readonly next: CommandName;
  /** Why a live stream has only dashes. */
  readonly none: ParseKeys;
}

const PLANS: Readonly<Record<"fms_plan" | "fms_hil_plan", Plan>> = {
  fms_plan: { previous: "fms_previous_waypoint", next: "fms_next_waypoint", none: "fms.none.fms_plan" },
  fms_hil_plan: {
    previous: "hil_fms_previous_waypoint",
    next: "hil_fms_next_waypoint",
    none: "fms.none.fms_hil_plan",
  },
};

const ROWS: readonly ReadoutRow<NumberField<"fms_plan">>[] = [
  { field: "bearing_deg", label: "fms.bearing", as: HEADING },
  { field: "altitude_ft", label: "fms.altitude", as: "altitude" },
  { field: "speed_kt", label: "fms.speed", as: "speed" },
  { field: "distance_m", label: "fms.distance", as: "distance" },
  { field: "waypoint", label: "fms.waypoint", as: COUNT },
];

/** Why a live stream has only dashes: the board flies by no plan. */
function NoPlan({ topic }: { topic: keyof typeof PLANS }) {
  const { t } = useTranslation();
  const isEmpty = useTelemetry(
    (telemetry, now_ms) =>
      telemetry.state(topic, now_ms) === "live" && telemetry.newestNumber(topic, "waypoint") === null,
  );
  return isEmpty ? <p className="live-note">{t(PLANS[topic].none)}</p> : null;
}

/** The targets of a flight plan, and two buttons that step through its waypoints. */
export function FmsReadouts({ topic, columns }: { topic: keyof typeof PLANS; columns: number }) {
  const { t } = useTranslation();
  const plan = PLANS[topic];
  return (
    <div className="live-fms">
      <NoPlan topic={topic} />
      <ReadoutTable topic={topic} rows={ROWS} columns={columns} size="large" chars={6} />
      <div className="live-fms-steps">
        <CommandButton command={plan.previous} icon={<ChevronLeft aria-hidden="true" />}>
          {t("fms.previous")}
        </CommandButton>
        <CommandButton command={plan.next} icon={<ChevronRight aria-hidden="true" />}>
          {t("fms.next")}
        </CommandButton>
      </div>
    </div>
  );
}
