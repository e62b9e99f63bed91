import { FilePlus2, RefreshCw } from "lucide-react";
import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { MAP_FILES } from "../../protocol/mapLayers";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FileButton } from "../../ui/FileButton";
import { Notice } from "../../ui/Notice";
import { ImportList } from "./layers/ImportList";
import { LayerRow } from "./layers/LayerRow";
import { MAP_LAYERS, useMapLayers } from "./layers/layerList";
import { RemovedList } from "./layers/RemovedList";
import { TerrainList } from "./layers/TerrainList";
import { useGround } from "./layers/useGround";
import { FoldingPanel } from "./panels/FoldingPanel";
import "./layers/layers.css";

/** The map layers in the user's order, and the terrain. */
export function LayersSection() {
  const { t } = useTranslation();
  const mapLayers = usePart(MAP_LAYERS);
  const ground = useGround();
  const folder = useMapLayers((layers) => layers.folder);
  const blocked = useGatewayBlocked();
  const isConnected = blocked === undefined;
  // Read again after a reconnection: the folder's content may have changed.
  useEffect(() => {
    if (isConnected) mapLayers.read();
  }, [mapLayers, isConnected]);
  return (
    <FoldingPanel name="layers" title={t("map.layers.title")} className="map-layers">
      <Failure />
      {ground.stack.length === 0 && <p className="map-layers-hint">{t("map.ground.plain")}</p>}
      <ul className="map-layers-list">
        {ground.stack.map((stacked, place) => (
          <LayerRow
            key={stacked.id}
            stacked={stacked}
            layer={ground.layerOf(stacked.id)}
            isTop={place === 0}
            isBottom={place === ground.stack.length - 1}
            onChange={(change) => ground.change(stacked.id, change)}
            onMove={(by) => ground.move(stacked.id, by)}
          />
        ))}
      </ul>
      <TerrainList {...ground} />
      <ImportList />
      <RemovedList />
      <FileButton
        accept={MAP_FILES}
        onFile={(file) => void mapLayers.importFile(file, { control: "map.import" })}
        icon={<FilePlus2 aria-hidden="true" size={14} />}
        disabledReason={blocked}
      >
        {t("map.layers.add")}
      </FileButton>
      <p className="map-layers-hint">{t("map.layers.addHint", { folder: folder ?? t("words.dash") })}</p>
    </FoldingPanel>
  );
}

function Failure() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const mapLayers = usePart(MAP_LAYERS);
  const failure = useMapLayers((layers) => layers.failure);
  return failure === null ? null : (
    <Notice level="error">
      <p>{t("map.layers.failed")}</p>
      <p>{sentence(failure)}</p>
      <Button onPress={() => mapLayers.read()} icon={<RefreshCw aria-hidden="true" size={14} />}>
        {t("map.layers.again")}
      </Button>
    </Notice>
  );
}
