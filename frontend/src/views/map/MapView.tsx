import { useRef } from "react";
import { useTranslation } from "react-i18next";
import { CameraSection } from "./CameraSection";
import { GlobeMissing } from "./GlobeMissing";
import { LayersSection } from "./LayersSection";
import { Attribution } from "./layers/Attribution";
import { MapDrop } from "./layers/MapDrop";
import { MapCorner } from "./MapCorner";
import { OnlineSection } from "./OnlineSection";
import { PlanSection } from "./PlanSection";
import { ThingCard } from "./ThingCard";
import { ThingsSection } from "./ThingsSection";
import { ToolsSection } from "./ToolsSection";
import { TrackSection } from "./TrackSection";
import { GlobeContext } from "./useGlobe";
import { useKeptGlobe } from "./useKeptGlobe";
import "./map.css";

/** "Mapa 3D": the globe with the flight, and beside it what belongs to it. */
export function MapView() {
  const { t } = useTranslation();
  const host = useRef<HTMLDivElement>(null);
  const { globe, problem, retry } = useKeptGlobe(host, true);
  return (
    <GlobeContext value={globe}>
      <div className="map">
        <section className="map-scene" aria-label={t("tab.map")}>
          <div ref={host} className="map-host" role="application" aria-label={t("map.view.scene")} />
          <MapCorner />
          <ThingCard />
          <Attribution />
          <MapDrop />
          {problem !== null && <GlobeMissing problem={problem} onRetry={retry} />}
        </section>
        <div className="map-side">
          <CameraSection />
          <ThingsSection />
          <TrackSection />
          <PlanSection />
          <ToolsSection />
          <LayersSection />
          <OnlineSection />
        </div>
      </div>
    </GlobeContext>
  );
}
