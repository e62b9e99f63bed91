import { Download } from "lucide-react";
import { useTranslation } from "react-i18next";
import { FIELD_WISH } from "../../store/fieldWish";
import { usePage, usePart, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { Panel } from "../../ui/Panel";
import { useMapLayers } from "./layers/layerList";

const SEEN = "map.fieldOffer";

/** Says, until it was answered once, that roads, heights and imagery come with a field's pack, while there is none. */
export function FieldOffer() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const wishes = usePart(FIELD_WISH);
  const isSeen = useSettings(({ choices }) => choices[SEEN] === "yes");
  const isBare = useMapLayers(
    ({ folder, layers }) => folder !== null && layers.every(({ format }) => format === "online"),
  );
  if (isSeen || !isBare) {
    return null;
  }
  const answered = (): void => choose(settings, SEEN, "yes");
  return (
    <Panel title={t("map.field.title")}>
      <p className="map-plan-hint">{t("map.field.offer")}</p>
      <div className="map-plan-buttons">
        <Button
          onPress={() => {
            answered();
            wishes.setState({ wish: { centre: null } });
          }}
          icon={<Download size={14} aria-hidden="true" />}
        >
          {t("map.field.prepare")}
        </Button>
        <Button onPress={answered}>{t("map.field.notNow")}</Button>
      </div>
    </Panel>
  );
}
