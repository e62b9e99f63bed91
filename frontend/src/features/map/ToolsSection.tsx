import { Crosshair, Ruler, Trash2, Undo2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { formatHeading } from "../../lib/format";
import { Button } from "../../ui/Button";
import { FoldingPanel } from "./panels/FoldingPanel";
import { useMeasuring } from "./tools/useMeasuring";

/** The distance tool: points clicked on the map or taken from its middle, and the distances between them. */
export function ToolsSection() {
  const { t } = useTranslation();
  const { tools, distance, isOn, setOn, places, setPlaces, legs } = useMeasuring();
  const written = (length_m: number): string => `${distance.format(length_m)} ${distance.label}`;
  const icon = { size: 14, "aria-hidden": true } as const;

  return (
    <FoldingPanel name="tools" title={t("map.tools.title")} className="map-tools">
      <div className="map-plan-buttons">
        <Button
          pressed={isOn}
          onPress={() => setOn(!isOn)}
          icon={<Ruler {...icon} />}
          disabledReason={tools === null ? t("map.view.loading") : undefined}
        >
          {t("map.tools.measure")}
        </Button>
        <Button
          onPress={() => {
            const place = tools?.centre() ?? null;
            if (place !== null) setPlaces((before) => [...before, place]);
          }}
          icon={<Crosshair {...icon} />}
          disabledReason={tools === null ? t("map.view.loading") : undefined}
        >
          {t("map.tools.fromCentre")}
        </Button>
        <Button
          onPress={() => setPlaces((before) => before.slice(0, -1))}
          icon={<Undo2 {...icon} />}
          label={t("map.tools.undo")}
          disabledReason={places.length === 0 ? t("map.tools.nothing") : undefined}
        >
          {null}
        </Button>
        <Button
          onPress={() => setPlaces(() => [])}
          icon={<Trash2 {...icon} />}
          label={t("map.tools.clear")}
          disabledReason={places.length === 0 ? t("map.tools.nothing") : undefined}
        >
          {null}
        </Button>
      </div>
      {isOn && <p className="map-layers-hint">{t("map.tools.hint")}</p>}
      <ol className="map-legs" aria-live="polite">
        {legs.map((leg, index) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: legs come and go at the end alone
          <li key={index}>
            {t("map.tools.leg", {
              distance: written(leg.distance_m),
              bearing: formatHeading(leg.bearing_deg, 0) ?? t("words.dash"),
            })}
          </li>
        ))}
      </ol>
      {legs.length > 1 && <p>{t("map.tools.total", { distance: written(legs.at(-1)?.total_m ?? 0) })}</p>}
    </FoldingPanel>
  );
}
