import { Pencil } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import { HeightFigure, WindFigure } from "../../readouts/AirFigures";
import { LiveReadout } from "../../readouts/LiveReadout";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { Dialog } from "../../ui/Dialog";
import { ReadoutGrid } from "../../ui/Readout";
import { Select } from "../../ui/Select";
import { chosenFigures, FIGURE_NAMES, FIGURES_CHOICE, type FigureName, figureOf } from "./figureChoice";

/** Six numbers that the person chooses. */
export function Figures({ aircraft }: { readonly aircraft: Aircraft }) {
  const { t } = useTranslation();
  const [isChoosing, setChoosing] = useState(false);
  const names = useSettings(({ choices }) => choices[FIGURES_CHOICE]);
  const shown = chosenFigures(names, aircraft);
  return (
    <section className="fly-figures" aria-label={t("fly.figures")}>
      <ReadoutGrid>
        {shown.map((name, place) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: one figure may stand in two places
          <OneFigure key={`${place} ${name}`} name={name} aircraft={aircraft} />
        ))}
      </ReadoutGrid>
      <Button
        onPress={() => setChoosing(true)}
        icon={<Pencil size={14} aria-hidden="true" />}
        label={t("fly.choose")}
      >
        {null}
      </Button>
      {isChoosing && <Choice shown={shown} onClose={() => setChoosing(false)} />}
    </section>
  );
}

function OneFigure({ name, aircraft }: { readonly name: FigureName; readonly aircraft: Aircraft }) {
  const figure = figureOf(name);
  if ("made" in figure) {
    return figure.made === "height" ? <HeightFigure aircraft={aircraft} /> : <WindFigure />;
  }
  return <LiveReadout {...figure} chars={6} />;
}

function Choice({ shown, onClose }: { readonly shown: readonly FigureName[]; readonly onClose: () => void }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const nameOf = useNameOf();
  const options = FIGURE_NAMES.map((value) => ({ value, label: nameOf(value) }));
  return (
    <Dialog
      title={t("fly.figures")}
      onClose={onClose}
      actions={<Button onPress={onClose}>{t("words.close")}</Button>}
    >
      <div className="fly-choice">
        {shown.map((name, place) => (
          <Select
            // biome-ignore lint/suspicious/noArrayIndexKey: the place is what is chosen for
            key={place}
            label={t("fly.place", { number: place + 1 })}
            options={options}
            value={name}
            placeholder=""
            onChange={(value) => choose(settings, FIGURES_CHOICE, shown.with(place, value).join(" "))}
          />
        ))}
        <Button onPress={() => choose(settings, FIGURES_CHOICE, "")}>{t("fly.usual")}</Button>
      </div>
    </Dialog>
  );
}

/** Its name with the aircraft that it is of, where both have one. */
function useNameOf(): (name: FigureName) => string {
  const { t } = useTranslation();
  return (name) => {
    const figure = figureOf(name);
    if ("made" in figure) {
      return t(figure.made === "height" ? "map.figures.height" : "map.figures.wind");
    }
    const isSimulated = figure.topic === "simulator" || figure.topic === "fms_hil_plan";
    const label = t(figure.label);
    return isSimulated ? t("fly.figure.of", { name: label, aircraft: t("map.view.hil") }) : label;
  };
}
