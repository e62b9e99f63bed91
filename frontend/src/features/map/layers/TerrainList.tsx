import { useTranslation } from "react-i18next";
import { useSentence } from "../../../i18n/useSentence";
import { formatBytes } from "../../../lib/format";
import { isConverting, type MapLayer } from "../../../protocol/mapLayers";
import { failureMessage } from "../../../store/messages";
import { Notice } from "../../../ui/Notice";
import { Select } from "../../../ui/Select";
import { useFlat } from "../scenes/useFlat";
import { DatumChoice } from "./DatumChoice";
import { RemoveLayer } from "./LayerRow";
import type { GroundChoice } from "./useGround";

/** The choice of the terrain, and every elevation file with what it lacks. */
export function TerrainList({ terrains, terrain, terrainFailed, chooseTerrain }: GroundChoice) {
  const { t } = useTranslation();
  const flat = useFlat();
  const usable = terrains.filter(({ problem }) => problem === null);
  return (
    <>
      <Select
        label={t("map.layers.terrain")}
        placeholder={t("map.layers.noTerrain")}
        value={terrain ?? ""}
        onChange={(id) => chooseTerrain(id === "" ? null : id)}
        options={[
          { value: "", label: t("map.layers.noTerrain") },
          ...usable.map(({ id, name }) => ({ value: id, label: name })),
        ]}
        disabledReason={flat.isShown ? t("map.flat.globeOnly") : undefined}
      />
      {terrainFailed && !flat.isShown && <Notice level="warning">{t("map.layers.terrainFailed")}</Notice>}
      {terrains.length > 0 && (
        <ul className="map-layers-list">
          {terrains.map((layer) => (
            <TerrainRow key={layer.id} layer={layer} />
          ))}
        </ul>
      )}
    </>
  );
}

function TerrainRow({ layer }: { layer: MapLayer }) {
  const sentence = useSentence();
  const { name, bytes, problem, problem_code, problem_params } = layer;
  const said = (detail: string): string =>
    sentence(failureMessage({ code: problem_code ?? "", detail, params: problem_params }));
  return (
    <li className="map-layer">
      <div className="map-layer-head">
        <span>{name}</span>
        <span className="map-layer-size">{bytes > 0 && formatBytes(bytes)}</span>
        <RemoveLayer layer={layer} reason={undefined} />
      </div>
      <DatumChoice layer={layer} />
      {problem !== null &&
        (isConverting(layer) ? (
          <p className="map-layers-hint">{said(problem)}</p>
        ) : (
          <Notice level="error">{said(problem)}</Notice>
        ))}
    </li>
  );
}
