import "./readouts.css";
import { ChevronLeft, ChevronRight } from "lucide-react";
import { useTranslation } from "react-i18next";
import type { CommandName } from "../protocol/messages.gen";
import { CommandButton } from "../requests/CommandButton";
import { ReadoutGrid } from "../ui/Readout";
import { heading, whole } from "./formats";
import { LiveReadout } from "./LiveReadout";

interface Plan {
  readonly previous: CommandName;
  readonly next: CommandName;
}

const PLANS: Readonly<Record<"fms_plan" | "fms_hil_plan", Plan>> = {
  fms_plan: { previous: "fms_previous_waypoint", next: "fms_next_waypoint" },
  fms_hil_plan: { previous: "hil_fms_previous_waypoint", next: "hil_fms_next_waypoint" },
};

/** What a flight plan asks for, and the two buttons that step through its waypoints. */
export function FmsReadouts({ topic, columns }: { topic: keyof typeof PLANS; columns: number }) {
  const { t } = useTranslation();
  const plan = PLANS[topic];
  return (
    <div className="live-fms">
      <ReadoutGrid columns={columns}>
        <LiveReadout
          size="large"
          chars={6}
          topic={topic}
          field="bearing_deg"
          format={heading}
          label={t("fms.bearing")}
          unit={t("unit.deg")}
        />
        <LiveReadout
          size="large"
          chars={6}
          topic={topic}
          field="altitude_ft"
          quantity="altitude"
          label={t("fms.altitude")}
        />
        <LiveReadout
          size="large"
          chars={6}
          topic={topic}
          field="speed_kt"
          quantity="speed"
          label={t("fms.speed")}
        />
        <LiveReadout
          size="large"
          chars={6}
          topic={topic}
          field="distance_m"
          quantity="distance"
          label={t("fms.distance")}
        />
        <LiveReadout
          size="large"
          chars={6}
          topic={topic}
          field="waypoint"
          format={whole}
          label={t("fms.waypoint")}
        />
      </ReadoutGrid>
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
