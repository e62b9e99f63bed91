import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import type { Globe } from "../../scene/globe/Globe";
import { Notice } from "../../ui/Notice";
import { CameraSection } from "./CameraSection";
import { LayersSection } from "./LayersSection";
import { Attribution } from "./layers/Attribution";
import { MapDrop } from "./layers/MapDrop";
import { MapCorner } from "./MapCorner";
import { PlanSection } from "./PlanSection";
import { ThingCard } from "./ThingCard";
import { ThingsSection } from "./ThingsSection";
import { ToolsSection } from "./ToolsSection";
import { TrackSection } from "./TrackSection";
import { GlobeContext } from "./useGlobe";
import "./map.css";

/** "Mapa 3D": the globe with the flight, and beside it what belongs to it. */
export function MapView() {
  const { t } = useTranslation();
  const host = useRef<HTMLDivElement>(null);
  const [globe, setGlobe] = useState<Globe | null>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    let shown: Globe | null = null;
    let isWanted = true;
    void import("../../scene/globe/kept")
      .then(({ keptGlobe }) => {
        if (isWanted && host.current !== null) {
          shown = keptGlobe();
          shown.attach(host.current);
          setGlobe(shown);
        }
      })
      .catch(() => setFailed(true));
    return () => {
      isWanted = false;
      shown?.detach();
    };
  }, []);
  return (
    <GlobeContext value={globe}>
      <div className="map">
        <section className="map-scene" aria-label={t("tab.map")}>
          <div ref={host} className="map-host" role="application" aria-label={t("map.view.scene")} />
          <MapCorner />
          <ThingCard />
          <Attribution />
          <MapDrop />
          {failed && <Notice level="warning">{t("map.view.noWebgl")}</Notice>}
        </section>
        <div className="map-side">
          <CameraSection />
          <ThingsSection />
          <TrackSection />
          <PlanSection />
          <ToolsSection />
          <LayersSection />
        </div>
      </div>
    </GlobeContext>
  );
}
