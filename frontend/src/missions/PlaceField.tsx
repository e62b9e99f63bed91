import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import { type CoordinateNotation, formatPlace, NOTATIONS, parsePlace } from "../lib/coordinates";
import type { Position } from "../lib/geodesy";
import { usePage, useSettings } from "../store/hooks";
import { choose } from "../store/settings";
import { useOpenEdit } from "../ui/openEdits";
import { useRefuse } from "../ui/refusal";
import { Select } from "../ui/Select";
import { useWords } from "../ui/words";
import "./place.css";

const CHOICE = "plans.notation";

interface Props {
  /** Null: none is known yet, the field is empty. */
  place: Position | null;
  /** Why it cannot be changed. */
  fixed: string | undefined;
  onCommit: (place: Position) => void;
}

/**
 * A waypoint's place in the notation that the person chose; typed in any of them. Enter and leaving the field finish an
 * edit, Escape takes it back. What is no place changes nothing, which is said until something else is typed.
 */
export function PlaceField({ place, fixed, onCommit }: Props) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const id = useId();
  const note = useId();
  const notation = useSettings(
    ({ choices }): CoordinateNotation => NOTATIONS.find((known) => known === choices[CHOICE]) ?? "decimal",
  );
  const words = useWords();
  const tell = useRefuse();
  const [typed, setTyped] = useState<string | null>(null);
  /** What was no place when the field was left. */
  const [refused, setRefused] = useState<string | null>(null);
  const shown = place === null ? "" : formatPlace(place, notation);
  const found = typed === null ? null : parsePlace(typed);
  const isWrong = typed !== null && typed.trim() !== "" && found === null;
  useOpenEdit(t("plans.place"), isWrong || refused !== null);
  const names: Readonly<Record<CoordinateNotation, string>> = {
    decimal: t("plans.notationDecimal"),
    dms: t("plans.notationDms"),
    utm: t("plans.notationUtm"),
  };

  function finish(): void {
    if (found !== null && typed !== shown) {
      onCommit({
        latitude_deg: Number(found.latitude_deg.toFixed(7)),
        longitude_deg: Number(found.longitude_deg.toFixed(7)),
      });
    }
    setTyped(null);
    setRefused(null);
  }

  function leave(): void {
    finish();
    if (isWrong) {
      setRefused(typed);
      tell(words.refusedEdit(typed, t("plans.noPlace")));
    }
  }

  return (
    <div className="place-field">
      <label htmlFor={id} className="ui-field-label">
        {t("plans.place")}
      </label>
      <input
        id={id}
        type="text"
        autoComplete="off"
        spellCheck={false}
        readOnly={fixed !== undefined}
        title={fixed}
        aria-invalid={isWrong || undefined}
        aria-describedby={note}
        value={typed ?? shown}
        onChange={(event) => {
          setTyped(event.currentTarget.value);
          setRefused(null);
        }}
        onBlur={() => typed !== null && leave()}
        onKeyDown={(event) => {
          if (event.key === "Enter" && !isWrong) finish();
          else if (event.key === "Escape" && typed !== null) setTyped(null);
          else if (event.key === "Escape" && refused !== null) setRefused(null);
          else return;
          event.preventDefault();
        }}
      />
      <Select
        label={t("plans.notation")}
        hideLabel
        placeholder=""
        value={notation}
        onChange={(value) => choose(settings, CHOICE, value)}
        options={NOTATIONS.map((value) => ({ value, label: names[value] }))}
      />
      <p id={note} className="place-note" role="status" data-wrong={isWrong || refused !== null}>
        {isWrong
          ? t("plans.noPlace")
          : refused === null
            ? t("plans.placeHint")
            : words.refusedEdit(refused, t("plans.noPlace"))}
      </p>
    </div>
  );
}
