import { X } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../../i18n/useSentence";
import { formatBytes } from "../../../lib/format";
import type { MapImport } from "../../../protocol/mapLayers";
import { useAsked } from "../../../requests/useAsked";
import { useGatewayBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { failureMessage } from "../../../store/messages";
import { Button } from "../../../ui/Button";
import { Notice } from "../../../ui/Notice";
import { MAP_LAYERS, useMapLayers } from "./layerList";

/** Files being imported, and failed imports. */
export function ImportList() {
  const imports = useMapLayers((layers) => layers.imports);
  const { state, stateText } = useAsked("map.import");
  const entries = Object.values(imports);
  // An upload that the station refused at once has no entry of its own.
  const isRefused = state === "rejected" && !entries.some((entry) => entry.state === "failed");
  return (
    <>
      {isRefused && <Notice level="error">{stateText}</Notice>}
      {entries.map((entry) =>
        entry.state === "failed" ? (
          <Failed key={entry.id} entry={entry} />
        ) : (
          <Underway key={entry.id} entry={entry} />
        ),
      )}
    </>
  );
}

function Underway({ entry }: { entry: MapImport }) {
  const { t } = useTranslation();
  const mapLayers = usePart(MAP_LAYERS);
  const control = `map.cancel.${entry.id}`;
  const { state, stateText } = useAsked(control);
  const text = useProgressText(entry);
  return (
    <div className="map-import">
      <label>
        <span>{text}</span>
        {/* Without a value the progress bar is indeterminate: the total is unknown. */}
        <progress max={100} value={entry.percent ?? undefined} />
      </label>
      <Button
        onPress={() => void mapLayers.cancelImport(entry.id, { control })}
        icon={<X size={14} aria-hidden="true" />}
        label={t("map.layers.cancel", { name: entry.name })}
        state={state}
        stateText={stateText}
        disabledReason={useGatewayBlocked()}
      >
        {null}
      </Button>
    </div>
  );
}

function useProgressText({ name, state, percent, bytes }: MapImport): string {
  const { t } = useTranslation();
  if (state === "converting") {
    return percent === null
      ? t("map.layers.convertingSome", { name })
      : t("map.layers.converting", { name, percent });
  }
  return percent === null
    ? t("map.layers.receivingSome", { name, bytes: formatBytes(bytes) })
    : t("map.layers.receiving", { name, percent });
}

function Failed({ entry }: { entry: MapImport }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const mapLayers = usePart(MAP_LAYERS);
  const { id, name, problem, problem_code, problem_params } = entry;
  return (
    <Notice level="error" onDismiss={() => mapLayers.forgetImport(id)}>
      <p>{t("map.layers.importFailed", { name })}</p>
      {problem !== null && (
        <p>
          {sentence(failureMessage({ code: problem_code ?? "", detail: problem, params: problem_params }))}
        </p>
      )}
    </Notice>
  );
}
