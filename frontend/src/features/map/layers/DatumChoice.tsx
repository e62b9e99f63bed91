import { useTranslation } from "react-i18next";
import { feetFromMetres } from "../../../lib/units";
import type { Datum, MapLayer } from "../../../protocol/mapLayers";
import { useUnit } from "../../../readouts/useUnit";
import { useGatewayBlocked } from "../../../requests/useBlocked";
import { usePart } from "../../../store/hooks";
import { Notice } from "../../../ui/Notice";
import { Select } from "../../../ui/Select";
import { MAP_LAYERS } from "./layerList";

const DATUMS: readonly Datum[] = ["orthometric", "ellipsoidal"];

/** What the heights of a set count from: as the set says it, or a question with what depends on the answer. */
export function DatumChoice({ layer }: { layer: MapLayer }) {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const mapLayers = usePart(MAP_LAYERS);
  const blocked = useGatewayBlocked();
  const { id, name, datum, datum_stated, geoid_m, problem } = layer;
  if (problem !== null || geoid_m === null) {
    return null;
  }
  if (datum_stated && datum !== null) {
    return <p className="map-layers-hint">{t(`mapDatumStated.${datum}`)}</p>;
  }
  const place = {
    latitude: middle(layer.south_deg, layer.north_deg),
    longitude: middle(layer.west_deg, layer.east_deg),
  };
  const difference = `${altitude.format(feetFromMetres(Math.abs(geoid_m)))} ${altitude.label}`;
  return (
    <>
      {datum === null && (
        <Notice level="warning">{t("map.layers.datumUnknown", { name, difference, ...place })}</Notice>
      )}
      <Select
        label={t("map.layers.datum", { name })}
        placeholder={t("map.layers.datumChoose")}
        value={datum}
        onChange={(chosen) => void mapLayers.chooseDatum(layer, chosen, { control: `map.datum.${id}` })}
        options={DATUMS.map((value) => ({ value, label: t(`mapDatum.${value}`) }))}
        disabledReason={blocked}
      />
    </>
  );
}

function middle(from_deg: number, to_deg: number): string {
  return ((from_deg + to_deg) / 2).toFixed(1);
}
