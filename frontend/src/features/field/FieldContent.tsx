import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Notice } from "../../ui/Notice";
import { EditScope } from "../../ui/openEdits";
import { FieldForm } from "./FieldForm";
import { FieldRow } from "./FieldRow";
import { FIELD } from "./field";
import { PackRow } from "./PackRow";
import "./field.css";

/** Bring heights and pictures of a field while there is a network: what is under way, what is there, and a new one. */
export function FieldContent() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const field = usePart(FIELD);
  const known = useStore(field.store, (state) => state.known);
  const packs = useStore(field.store, (state) => state.packs);
  const failure = useStore(field.store, (state) => state.failure);
  const isConnected = useGatewayBlocked() === undefined;
  useEffect(() => {
    if (isConnected) void field.read();
  }, [field, isConnected]);
  const underWay = known?.fields.filter(({ state }) => state !== "done") ?? [];
  return (
    <div className="field">
      <p className="field-hint">{t("field.what")}</p>
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      {underWay.length > 0 && (
        <ul className="field-list" aria-label={t("field.underWay")}>
          {underWay.map((one) => (
            <FieldRow key={one.id} field={one} />
          ))}
        </ul>
      )}
      {packs.length > 0 && (
        <section>
          <h3>{t("field.there")}</h3>
          <ul className="field-list">
            {packs.map((pack) => (
              <PackRow key={pack.id} pack={pack} />
            ))}
          </ul>
        </section>
      )}
      <EditScope>{known !== null && <FieldForm sources={known.sources} />}</EditScope>
    </div>
  );
}
