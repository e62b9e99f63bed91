import { Crosshair, Ruler, Trash2, Undo2 } from "lucide-react";
import { useCallback, useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { formatHeading } from "../../lib/format";
import { bearing_deg, distance_m } from "../../lib/geodesy";
import { useUnit } from "../../readouts/useUnit";
import type { GroundPlace } from "../../scene/tools/MapPointer";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { FoldingPanel } from "./FoldingPanel";
import { chooseTool, MAP_TOOL } from "./tools/mapTool";
import { useMapTool } from "./tools/useMapTool";
import { useScreenTools } from "./tools/useScreenTools";

interface Leg {
  readonly distance_m: number;
  readonly bearing_deg: number | null;
  readonly total_m: number;
}

/** The legs from each point to the next, with the sum so far. */
export function measuredLegs(places: readonly GroundPlace[]): readonly Leg[] {
  let total_m = 0;
  return places.slice(1).map((to, index) => {
    const from = places[index] ?? to;
    const length_m = distance_m(from, to);
    total_m += length_m;
    return { distance_m: length_m, bearing_deg: bearing_deg(from, to), total_m };
  });
}

/** The distance tool: points clicked on the map or taken from its middle, and the distances between them. */
export function ToolsSection() {
  const { t } = useTranslation();
  const tools = useScreenTools();
  const distance = useUnit("distance");
  const mapTool = usePart(MAP_TOOL);
  const isOn = useMapTool(({ tool }) => tool === "measure");
  const places = useMapTool(({ measured }) => measured);
  const setOn = useCallback((on: boolean) => chooseTool(mapTool, on ? "measure" : "pick"), [mapTool]);
  const setPlaces = useCallback(
    (change: (before: readonly GroundPlace[]) => readonly GroundPlace[]) =>
      mapTool.setState(({ measured }) => ({ measured: change(measured) })),
    [mapTool],
  );
  const legs = useMemo(() => measuredLegs(places), [places]);
  const written = (length_m: number): string => `${distance.format(length_m)} ${distance.label}`;
  const icon = { size: 14, "aria-hidden": true } as const;

  useEffect(() => {
    if (!isOn) return undefined;
    tools?.measure((place) => setPlaces((before) => [...before, place]));
    return () => tools?.measure(null);
  }, [tools, isOn, setPlaces]);
  useEffect(() => {
    tools?.showDistance(
      places.map((place, index) => {
        const leg = legs[index - 1];
        const label = leg === undefined ? "" : `${distance.format(leg.total_m)} ${distance.label}`;
        return { ...place, label };
      }),
    );
  }, [tools, places, legs, distance]);
  useEffect(() => {
    if (!isOn) return undefined;
    const press = (event: KeyboardEvent): void => {
      const isTyping = event.target instanceof HTMLElement && event.target.matches("input, select, textarea");
      if (event.defaultPrevented || isTyping) return;
      if (event.key === "Escape") setOn(false);
      else if (event.key === "Backspace") setPlaces((before) => before.slice(0, -1));
      else return;
      event.preventDefault();
    };
    window.addEventListener("keydown", press, { capture: true });
    return () => window.removeEventListener("keydown", press, { capture: true });
  }, [isOn, setOn, setPlaces]);

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
