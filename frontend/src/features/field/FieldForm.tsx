import { Download, LocateFixed } from "lucide-react";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { formatBytes } from "../../lib/format";
import type { Position } from "../../lib/geodesy";
import { PlaceField } from "../../missions/PlaceField";
import { usePlans } from "../../missions/planDrafts";
import type { FieldSource } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { FIELD_WISH } from "../../store/fieldWish";
import { usePart, useTelemetry } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { Notice } from "../../ui/Notice";
import { NumberField } from "../../ui/NumberField";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { type Draft, KINDS, newDraft, orderOf, readyDraft } from "./draft";
import { FIELD, type FieldOrder } from "./field";
import { SourceChoice } from "./SourceChoice";

const CONTROL = "field.prepare";
const MOST_KM = 200;

/** A new field: where, from which sources, and what that takes. Nothing is asked for before the button is pressed. */
export function FieldForm({ sources }: { sources: readonly FieldSource[] }) {
  const { t } = useTranslation();
  const field = usePart(FIELD);
  const blocked = useGatewayBlocked();
  const { state, stateText } = useAsked(CONTROL);
  const plans = {
    flight: usePlans(({ flight }) => flight.draft.present),
    hil: usePlans(({ hil }) => hil.draft.present),
  };
  const aircraft = useAircraft();
  const wishes = usePart(FIELD_WISH);
  // The place that was pointed at on the map, for this window alone.
  useEffect(() => () => wishes.setState({ wish: null }), [wishes]);
  const [draft, setDraft] = useState<Draft>(() =>
    newDraft(wishes.getState().wish?.centre ?? aircraft ?? plans.flight[0] ?? plans.hil[0] ?? null, ""),
  );
  const [accepted, setAccepted] = useState<string | null>(null);
  const isFirst = useStore(
    field.store,
    ({ known, packs }) => packs.length + (known?.fields.length ?? 0) === 0,
  );
  const plan = draft.where === "circle" ? [] : plans[draft.where];
  const order = orderOf(draft, plan, sources);
  const ready = readyDraft(draft, sources);
  const readyOrder = useLook(order, ready, plan, sources);
  // Terms are accepted for the sources that were shown: other ones are other terms.
  const terms = JSON.stringify(order?.parts.map(({ url }) => url));
  const isAccepted = accepted === terms;

  function edit(change: Partial<Draft>): void {
    setDraft((before) => ({ ...before, ...change }));
  }

  return (
    <section className="field-form" aria-label={t(isFirst ? "field.first" : "field.new")}>
      <h3>{t(isFirst ? "field.first" : "field.new")}</h3>
      <TextField
        label={t("field.name")}
        value={draft.name}
        onCommit={(name) => edit({ name: name.slice(0, 60) })}
      />
      <Select
        label={t("field.where")}
        value={draft.where}
        placeholder=""
        options={[
          { value: "circle", label: t("field.circle") },
          { value: "flight", label: t("field.planFlight") },
          { value: "hil", label: t("field.planHil") },
        ]}
        onChange={(where) => edit({ where })}
      />
      {draft.where === "circle" ? (
        <>
          <PlaceField place={draft.centre} fixed={undefined} onCommit={(centre) => edit({ centre })} />
          <Button
            onPress={() => aircraft !== null && edit({ centre: aircraft })}
            icon={<LocateFixed size={14} aria-hidden="true" />}
            disabledReason={aircraft === null ? t("field.noAircraft") : undefined}
          >
            {t("field.atAircraft")}
          </Button>
        </>
      ) : (
        plan.length === 0 && <Notice level="info">{t("field.noPlan")}</Notice>
      )}
      <NumberField
        label={t(draft.where === "circle" ? "field.radius" : "field.buffer")}
        value={draft.radius_km}
        minimum={0.5}
        maximum={MOST_KM}
        step={1}
        unit={t("unit.km")}
        onCommit={(radius_km) => edit({ radius_km })}
      />
      <ReadySet ready={ready} canTake={readyOrder !== null} onTake={setDraft} />
      {KINDS.map((kind) => (
        <SourceChoice
          key={kind}
          kind={kind}
          draft={draft.parts[kind]}
          sources={sources}
          onChange={(part) => edit({ parts: { ...draft.parts, [kind]: part } })}
        />
      ))}
      {ready === null && <Estimate />}
      <Checkbox
        label={t("field.accept")}
        checked={isAccepted}
        onChange={(is) => setAccepted(is ? terms : null)}
        disabledReason={order === null ? t("field.notYet") : undefined}
      />
      <Button
        takesFields
        variant="primary"
        onPress={() => order !== null && void field.prepare(order, { control: CONTROL })}
        icon={<Download size={14} aria-hidden="true" />}
        state={state}
        stateText={stateText}
        disabledReason={
          blocked ?? (order === null ? t("field.notYet") : isAccepted ? undefined : t("field.notAccepted"))
        }
      >
        {t("field.begin")}
      </Button>
      {state === "rejected" && <Notice level="error">{stateText}</Notice>}
    </section>
  );
}

/** Asks what the order takes, or what the ready set would while nothing is ordered. Returns that set's order. */
function useLook(
  order: FieldOrder | null,
  ready: Draft | null,
  plan: readonly Position[],
  sources: readonly FieldSource[],
): FieldOrder | null {
  const field = usePart(FIELD);
  const readyOrder = ready === null ? null : orderOf(ready, plan, sources);
  const asked = JSON.stringify(order ?? readyOrder);
  useEffect(() => void field.look(JSON.parse(asked)), [field, asked]);
  return readyOrder;
}

/** A set of sources for any place, with what it takes before it is chosen. */
function ReadySet(props: {
  readonly ready: Draft | null;
  readonly canTake: boolean;
  readonly onTake: (ready: Draft) => void;
}) {
  const { ready, canTake, onTake } = props;
  const { t } = useTranslation();
  if (ready === null) {
    return null;
  }
  return (
    <div className="field-ready">
      <Button onPress={() => onTake(ready)} disabledReason={canTake ? undefined : t("field.noPlace")}>
        {t("field.ready")}
      </Button>
      <p className="field-hint">{t("field.readyHint")}</p>
      {canTake && <Estimate />}
    </div>
  );
}

function Estimate() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const found = useStore(usePart(FIELD).store, (state) => state.estimate);
  if (found === null) {
    return null;
  }
  if (!("levels" in found)) {
    return <Notice level="warning">{sentence(found)}</Notice>;
  }
  const { tiles, bytes, free_bytes, levels } = found;
  return (
    <div role="status" className="field-estimate">
      <p>{t("field.takes", { tiles, bytes: formatBytes(bytes), free: formatBytes(free_bytes) })}</p>
      <ul>
        {levels.map((level) => (
          <li key={`${level.kind}${level.zoom}`}>
            {t(level.zoom < 0 ? "field.degrees" : "field.level", {
              kind: t(`fieldKind.${level.kind}`),
              zoom: level.zoom,
              tiles: level.tiles,
              bytes: formatBytes(level.bytes),
            })}
          </li>
        ))}
      </ul>
      {bytes > free_bytes && <Notice level="warning">{t("field.noRoom")}</Notice>}
    </div>
  );
}

/** Where the aircraft is, while that is known. */
function useAircraft(): Position | null {
  const latitude_deg = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber("gps", "latitude_deg", now_ms),
  );
  const longitude_deg = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber("gps", "longitude_deg", now_ms),
  );
  return latitude_deg === null || longitude_deg === null ? null : { latitude_deg, longitude_deg };
}
