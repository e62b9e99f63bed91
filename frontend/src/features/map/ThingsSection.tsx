import { House, Plane } from "lucide-react";
import { useTranslation } from "react-i18next";
import type { MapThing } from "../../lib/aircraft";
import { SELECTION, selectThing, useMapThing } from "../../missions/selection";
import { usePart, useTelemetry } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { PLACE_TOPIC } from "./aircraft/aircraftPlace";
import { LookAt } from "./LookAt";
import { FoldingPanel } from "./panels/FoldingPanel";

/** Buttons for what can be clicked on the map, for keyboard users. Waypoints are selected with their plan. */
export function ThingsSection() {
  const { t } = useTranslation();
  const selection = usePart(SELECTION);
  const chosen = useMapThing();
  const flight = useTelemetry((telemetry, now_ms) => telemetry.state(PLACE_TOPIC.flight, now_ms));
  const hil = useTelemetry((telemetry, now_ms) => telemetry.state(PLACE_TOPIC.hil, now_ms));
  const unheard = t("map.plan.unheard");
  const things: ReadonlyArray<{ thing: MapThing; label: string; reason: string | undefined }> = [
    {
      thing: { kind: "aircraft", plan: "flight" },
      label: t("map.plan.aircraftFlight"),
      reason: flight === "none" ? unheard : undefined,
    },
    {
      thing: { kind: "aircraft", plan: "hil" },
      label: t("map.plan.aircraftHil"),
      reason: hil === "none" ? unheard : undefined,
    },
    { thing: { kind: "home" }, label: t("map.plan.home"), reason: undefined },
  ];
  return (
    <FoldingPanel name="things" title={t("map.plan.things")}>
      <div className="map-plan-buttons">
        {things.map(({ thing, label, reason }) => {
          const isChosen = isSame(thing, chosen);
          return (
            <Button
              key={label}
              pressed={isChosen}
              onPress={() => selectThing(selection, isChosen ? null : thing)}
              disabledReason={reason}
              icon={
                thing.kind === "home" ? (
                  <House size={14} aria-hidden="true" />
                ) : (
                  <Plane size={14} aria-hidden="true" />
                )
              }
            >
              {label}
            </Button>
          );
        })}
      </div>
      <LookAt />
    </FoldingPanel>
  );
}

function isSame(one: MapThing, other: MapThing | null): boolean {
  return one.kind === "aircraft"
    ? other?.kind === "aircraft" && one.plan === other.plan
    : one.kind === other?.kind;
}
