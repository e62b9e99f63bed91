import { Undo2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useAsked } from "../../../requests/useAsked";
import { useGatewayBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { MAP_LAYERS, useMapLayers } from "./layerList";

/** Layers removed here, with a button to restore each. */
export function RemovedList() {
  const removed = useMapLayers((layers) => layers.removed);
  return removed.map((layer) => <Removed key={layer.id} layer={layer} />);
}

function Removed({ layer }: { layer: { readonly id: string; readonly name: string } }) {
  const { t } = useTranslation();
  const mapLayers = usePart(MAP_LAYERS);
  const control = `map.restore.${layer.id}`;
  const { state, stateText } = useAsked(control);
  return (
    <Button
      onPress={() => void mapLayers.restore(layer, { control })}
      icon={<Undo2 size={14} aria-hidden="true" />}
      state={state}
      stateText={stateText}
      disabledReason={useGatewayBlocked()}
    >
      {t("map.layers.restore", { name: layer.name })}
    </Button>
  );
}
