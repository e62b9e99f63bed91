import { useTranslation } from "react-i18next";
import type { FieldSource } from "../../protocol/guards.gen";
import { NumberField } from "../../ui/NumberField";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { hasLevels, highestZoom, type Kind, NONE, OWN, type PartDraft } from "./draft";

const URL_HINT = {
  heights: "field.urlHeights",
  imagery: "field.urlHint",
  vector: "field.urlVector",
} as const;

/** Sources whose terms the catalogues have; those of another station's version come as it says them. */
const KNOWN_IDS = ["terrain-tiles", "copernicus-glo30", "pnoa", "sentinel2", "usgs"] as const;
type KnownId = (typeof KNOWN_IDS)[number];
const KNOWN: ReadonlySet<string> = new Set(KNOWN_IDS);

interface Props {
  kind: Kind;
  draft: PartDraft;
  sources: readonly FieldSource[];
  onChange: (draft: PartDraft) => void;
}

/** Where one kind comes from: nowhere, a public source with its terms, or an address of one's own. */
export function SourceChoice({ kind, draft, sources, onChange }: Props) {
  const { t } = useTranslation();
  const offered = sources.filter((source) => source.kind === kind);
  const chosen = offered.find(({ id }) => id === draft.source);
  const name = t(`fieldKind.${kind}`);
  const url = chosen?.url ?? draft.url;

  function choose(source: string): void {
    const found = offered.find(({ id }) => id === source);
    onChange({ ...draft, source, zoom: found?.usual_zoom ?? draft.zoom });
  }

  return (
    <fieldset className="field-source">
      <legend>{name}</legend>
      <Select
        label={t("field.source", { kind: name })}
        hideLabel
        value={draft.source}
        placeholder=""
        options={[
          { value: NONE, label: t("field.none") },
          ...offered.map((source) => ({ value: source.id, label: source.name })),
          { value: OWN, label: t("field.own") },
        ]}
        onChange={choose}
      />
      {chosen !== undefined && (
        <p className="field-hint">
          {`${KNOWN.has(chosen.id) ? t(`fieldTerms.${chosen.id as KnownId}`) : chosen.terms} ${chosen.attribution}. `}
          <a href={chosen.terms_url} target="_blank" rel="noreferrer">
            {t("field.terms")}
          </a>
        </p>
      )}
      {draft.source === OWN && (
        <>
          <TextField
            label={t("field.url", { kind: name })}
            value={draft.url}
            onCommit={(text) => onChange({ ...draft, url: text })}
            hint={t(URL_HINT[kind])}
            monospace
          />
          <TextField
            label={t("field.attribution", { kind: name })}
            value={draft.attribution}
            onCommit={(attribution) => onChange({ ...draft, attribution })}
          />
        </>
      )}
      {draft.source !== NONE && hasLevels(url) && (
        <NumberField
          label={t("field.zoom", { kind: name })}
          value={draft.zoom}
          minimum={8}
          maximum={highestZoom(kind, chosen)}
          step={1}
          onCommit={(zoom) => onChange({ ...draft, zoom: Math.round(zoom) })}
        />
      )}
    </fieldset>
  );
}
