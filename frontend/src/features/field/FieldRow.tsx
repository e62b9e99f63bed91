import { Pause, Play, Trash2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatBytes } from "../../lib/format";
import type { PreparedField } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { FIELD } from "./field";

/** A field on its way: how far, how fast, how long still, and why nothing comes. */
export function FieldRow({ field }: { field: PreparedField }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const fields = usePart(FIELD);
  const blocked = useGatewayBlocked();
  const control = `field.${field.id}`;
  const { state, stateText } = useAsked(control);
  const isRunning = field.state === "running";
  const share = field.percent ?? (field.tiles * 100) / Math.max(1, field.tiles_total);
  return (
    <li className="field-row">
      <h3>{field.name}</h3>
      <progress aria-label={t("field.progress", { name: field.name })} max={100} value={share} />
      <p>{`${t(`fieldState.${field.state}`)} · ${t(`fieldDoing.${field.doing}`)}`}</p>
      <p className="field-figures">{figures()}</p>
      {field.problem !== null && (
        <Notice level={field.state === "failed" ? "error" : "warning"}>
          {sentence(
            failureMessage({
              code: field.problem_code ?? "",
              detail: field.problem,
              params: field.problem_params,
            }),
          )}
          {field.waits_s !== null && ` ${t("field.again", { seconds: Math.ceil(field.waits_s) })}`}
        </Notice>
      )}
      <div className="field-tools">
        <Button
          onPress={() => void (isRunning ? fields.pause : fields.resume)(field.id, { control })}
          icon={isRunning ? <Pause size={14} aria-hidden="true" /> : <Play size={14} aria-hidden="true" />}
          state={state}
          stateText={stateText}
          disabledReason={blocked}
        >
          {t(isRunning ? "field.pause" : "field.resume")}
        </Button>
        <Button
          onPress={() => void fields.forget(field, { control })}
          icon={<Trash2 size={14} aria-hidden="true" />}
          disabledReason={blocked}
        >
          {t("field.forget")}
        </Button>
      </div>
    </li>
  );

  function figures(): string {
    const told = [
      t("field.tiles", { tiles: field.tiles, all: field.tiles_total }),
      t("field.bytes", { bytes: formatBytes(field.bytes), all: formatBytes(field.bytes_total) }),
    ];
    if (isRunning && field.bytes_per_s > 0) {
      told.push(t("field.rate", { bytes: formatBytes(field.bytes_per_s) }));
    }
    if (isRunning && field.left_s !== null) {
      told.push(t("field.left", { minutes: Math.max(1, Math.ceil(field.left_s / 60)) }));
    }
    if (field.tiles_missing > 0) {
      told.push(t("field.missing", { tiles: field.tiles_missing }));
    }
    if (field.retries > 0) {
      told.push(t("field.retries", { times: field.retries }));
    }
    return told.join(" · ");
  }
}
