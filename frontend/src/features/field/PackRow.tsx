import { Download, ShieldCheck, Trash2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { formatBytes } from "../../lib/format";
import type { MapLayer } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { FIELD, LAYERS } from "./field";

/** A field that is there: proof that it is whole, its file for another station, and its end. */
export function PackRow({ pack }: { pack: MapLayer }) {
  const { t } = useTranslation();
  const fields = usePart(FIELD);
  const blocked = useGatewayBlocked();
  const proof = useAsked(`field.prove.${pack.id}`);
  const removal = useAsked(`field.remove.${pack.id}`);
  const [isAsking, setAsking] = useState(false);
  return (
    <li className="field-row">
      <h4>{`${pack.name} · ${formatBytes(pack.bytes)}`}</h4>
      <p className="field-hint">{pack.attribution}</p>
      <div className="field-tools">
        <Button
          onPress={() => void fields.prove(pack, { control: `field.prove.${pack.id}` })}
          icon={<ShieldCheck size={14} aria-hidden="true" />}
          state={proof.state}
          stateText={proof.stateText}
          disabledReason={blocked}
        >
          {t("field.prove")}
        </Button>
        <a className="field-export" href={`${LAYERS}/${pack.id}/file`} download>
          <Download size={14} aria-hidden="true" />
          {t("field.export")}
        </a>
        <Button
          onPress={() => setAsking(true)}
          icon={<Trash2 size={14} aria-hidden="true" />}
          label={t("field.removeNamed", { name: pack.name })}
          state={removal.state}
          stateText={removal.stateText}
          disabledReason={blocked}
        >
          {t("field.remove")}
        </Button>
      </div>
      {proof.state === "rejected" && <p role="alert">{proof.stateText}</p>}
      {isAsking && (
        <ConfirmDialog
          title={t("field.removeTitle", { name: pack.name })}
          text={t("field.removeText")}
          confirmLabel={t("field.removeYes")}
          cancelLabel={t("field.keep")}
          danger
          onConfirm={() => {
            setAsking(false);
            void fields.remove(pack, { control: `field.remove.${pack.id}` });
          }}
          onCancel={() => setAsking(false)}
        />
      )}
    </li>
  );
}
