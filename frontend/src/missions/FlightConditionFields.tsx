import { useTranslation } from "react-i18next";
import type { PlanName } from "../protocol/missions";
import { useUnit } from "../readouts/useUnit";
import { windNow } from "../readouts/wind";
import { usePage, useSettings } from "../store/hooks";
import { choose } from "../store/settings";
import { Button } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { ENDURANCE_CHOICE } from "./rehearsal";
import { useEnteredWind, useHasWind, WIND_CHOICES } from "./useWind";

/** Stronger wind than this is a mistake of the person or of the estimate. */
const STRONGEST_KT = 100;
const LONGEST_MIN = 600;

/** The wind in which a plan is flown, entered or from the aircraft, and how long the battery lasts. */
export function FlightConditionFields({ plan }: { plan: PlanName }) {
  const { t } = useTranslation();
  const { settings, telemetry, pump } = usePage();
  const speed = useUnit("speed");
  const wind = useEnteredWind();
  const hasWind = useHasWind(plan);
  const endurance = useSettings(({ choices }) => Number(choices[ENDURANCE_CHOICE] ?? 0));

  function take(): void {
    const found = windNow(telemetry, plan, pump.now_ms);
    if (found !== null) {
      choose(settings, WIND_CHOICES.from, found.from_deg.toFixed(0));
      choose(settings, WIND_CHOICES.speed, found.speed_kt.toFixed(1));
    }
  }

  return (
    <>
      <NumberField
        label={t("rehearsal.windFrom")}
        value={wind.from_deg}
        minimum={0}
        maximum={360}
        step={10}
        format={(value) => value.toFixed(0)}
        unit={t("unit.deg")}
        onCommit={(value) => choose(settings, WIND_CHOICES.from, String(value))}
      />
      <NumberField
        label={t("rehearsal.wind")}
        value={speed.convert(wind.speed_kt)}
        minimum={0}
        maximum={speed.convert(STRONGEST_KT)}
        step={1}
        format={(value) => value.toFixed(speed.digits)}
        unit={speed.label}
        onCommit={(shown) => choose(settings, WIND_CHOICES.speed, String(speed.revert(shown)))}
      />
      <Button onPress={take} disabledReason={hasWind ? undefined : t("rehearsal.noWind")}>
        {t("rehearsal.takeWind")}
      </Button>
      <NumberField
        label={t("rehearsal.endurance")}
        value={endurance > 0 ? endurance : null}
        minimum={0}
        maximum={LONGEST_MIN}
        step={5}
        format={(value) => value.toFixed(0)}
        unit={t("unit.min")}
        onCommit={(value) => choose(settings, ENDURANCE_CHOICE, String(value))}
      />
    </>
  );
}
