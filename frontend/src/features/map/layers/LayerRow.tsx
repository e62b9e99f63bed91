import { ArrowDown, ArrowUp, Trash2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../../i18n/useSentence";
import { formatBytes } from "../../../lib/format";
import type { MapLayer } from "../../../protocol/mapLayers";
import { useAsked } from "../../../requests/useAsked";
import { useGatewayBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { failureMessage } from "../../../store/messages";
import { Button } from "../../../ui/Button";
import { Checkbox } from "../../../ui/Checkbox";
import { Notice } from "../../../ui/Notice";
import { RangeField } from "../../../ui/RangeField";
import { MAP_LAYERS } from "./layerList";
import type { StackLayer } from "./mapStack";

interface Props {
  stacked: StackLayer;
  layer: MapLayer | undefined;
  isTop: boolean;
  isBottom: boolean;
  onChange: (change: Partial<Omit<StackLayer, "id">>) => void;
  onMove: (by: -1 | 1) => void;
}

/** One image layer: whether it is shown, its opacity, and its place in the order. */
export function LayerRow({ stacked, layer, isTop, isBottom, onChange, onMove }: Props) {
  const { t } = useTranslation();
  const sentence = useSentence();
  if (layer === undefined) {
    return null;
  }
  const { name, format, bytes, problem, problem_code, problem_params } = layer;
  const icon = { size: 14, "aria-hidden": true } as const;
  const failure =
    problem === null
      ? null
      : sentence(failureMessage({ code: problem_code ?? "", detail: problem, params: problem_params }));
  return (
    <li className="map-layer">
      <div className="map-layer-head">
        <Checkbox
          label={name}
          checked={stacked.isOn && problem === null}
          onChange={(isOn) => onChange({ isOn })}
          disabledReason={failure ?? undefined}
        />
        <span className="map-layer-size">{bytes > 0 && formatBytes(bytes)}</span>
      </div>
      {failure !== null && <Notice level="error">{failure}</Notice>}
      {stacked.isOn && failure === null && (
        <RangeField
          label={t("map.layers.opacity", { name })}
          value={stacked.opacity}
          minimum={0}
          maximum={1}
          step={0.05}
          text={`${Math.round(stacked.opacity * 100)} %`}
          onChange={(opacity) => onChange({ opacity })}
        />
      )}
      <div className="map-plan-buttons">
        <Button
          onPress={() => onMove(-1)}
          icon={<ArrowUp {...icon} />}
          label={t("map.layers.up", { name })}
          disabledReason={isTop ? t("map.layers.top") : undefined}
        >
          {null}
        </Button>
        <Button
          onPress={() => onMove(1)}
          icon={<ArrowDown {...icon} />}
          label={t("map.layers.down", { name })}
          disabledReason={isBottom ? t("map.layers.bottom") : undefined}
        >
          {null}
        </Button>
        <RemoveLayer layer={layer} reason={format === "online" ? t("map.layers.removeBase") : undefined} />
      </div>
    </li>
  );
}

/** Removes a file from the list, without a question: it can be restored. */
export function RemoveLayer({ layer, reason }: { layer: MapLayer; reason: string | undefined }) {
  const { t } = useTranslation();
  const mapLayers = usePart(MAP_LAYERS);
  const blocked = useGatewayBlocked();
  const control = `map.remove.${layer.id}`;
  const { state, stateText } = useAsked(control);
  return (
    <Button
      onPress={() => void mapLayers.remove(layer, { control })}
      icon={<Trash2 size={14} aria-hidden="true" />}
      label={t("map.layers.remove", { name: layer.name })}
      state={state}
      stateText={stateText}
      disabledReason={reason ?? blocked}
    >
      {null}
    </Button>
  );
}
