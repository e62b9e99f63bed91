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

interface Props {
  readonly aircraft: Aircraft;
  /** Plot a signal, named as recordings name it. */
  readonly onPlot: (signal: string) => void;
}

/** Six numbers that the person chooses; a press on one plots it. */
export function Figures({ aircraft, onPlot }: Props) {
  const { t } = useTranslation();
  const [isChoosing, setChoosing] = useState(false);
  const names = useSettings(({ choices }) => choices[FIGURES_CHOICE]);
  const shown = chosenFigures(names, aircraft);
  return (
    <section className="fly-figures" aria-label={t("fly.figures")}>
      <ReadoutGrid>
        {shown.map((name, place) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: one figure may stand in two places
          <OneFigure key={`${place} ${name}`} name={name} aircraft={aircraft} onPlot={onPlot} />
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

function OneFigure({ name, aircraft, onPlot }: Props & { readonly name: FigureName }) {
  const { t } = useTranslation();
  const figure = figureOf(name);
  if ("made" in figure) {
    const isHeight = figure.made === "height";
    const press = {
      label: t("fly.plot", { name: t(isHeight ? "map.figures.height" : "map.figures.wind") }),
      disabledReason: t("fly.notRecorded"),
      onPress: () => undefined,
    };
    return isHeight ? <HeightFigure aircraft={aircraft} press={press} /> : <WindFigure press={press} />;
  }
  const press = {
    label: t("fly.plot", { name: t(figure.label) }),
    onPress: () => onPlot(`${figure.topic}.${figure.field}`),
  };
  return <LiveReadout {...figure} chars={6} press={press} />;
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
