import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { WindState } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { NumberField } from "../../ui/NumberField";
import { Select } from "../../ui/Select";
import { BLOW, FAULTS } from "./faultRequests";

const TURBULENCE = ["none", "light", "moderate", "severe"] as const;
const HIGHEST_KT = 100;

/** Steady wind and turbulence of the simulator: what blows, until something else is typed, and sent by the button. */
export function WindForm({ wind }: { readonly wind: WindState }) {
  const { t } = useTranslation();
  const { blow } = usePart(FAULTS);
  const { state, stateText } = useAsked(BLOW);
  const [draft, setDraft] = useState<Partial<WindState>>({});
  const wanted: WindState = { ...wind, ...draft };
  const change = (part: Partial<WindState>): void => setDraft((before) => ({ ...before, ...part }));
  return (
    <fieldset className="faults-wind">
      <legend>{t("faults.wind")}</legend>
      <NumberField
        label={t("faults.windFrom")}
        value={wanted.from_deg}
        onCommit={(from_deg) => change({ from_deg })}
        minimum={0}
        maximum={360}
        step={10}
        unit={t("unit.deg")}
      />
      <NumberField
        label={t("faults.windSpeed")}
        value={wanted.speed_kt}
        onCommit={(speed_kt) => change({ speed_kt })}
        minimum={0}
        maximum={HIGHEST_KT}
        step={5}
        unit={t("unit.kt")}
      />
      <Select
        label={t("faults.turbulence")}
        options={TURBULENCE.map((value) => ({ value, label: t(`turbulence.${value}`) }))}
        value={wanted.turbulence}
        onChange={(turbulence) => change({ turbulence })}
        placeholder={t("faults.turbulence")}
      />
      <Button
        takesFields
        onPress={() => void blow(wanted).then(() => setDraft({}))}
        state={state}
        stateText={stateText}
      >
        {t("faults.setWind")}
      </Button>
    </fieldset>
  );
}
