import { useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import type { FlatScene } from "../../scene/flat/FlatScene";
import { AirfieldsSection } from "./airfields/AirfieldsSection";
import { CameraSection } from "./CameraSection";
import { EditBar } from "./edit/EditBar";
import { MapKeys } from "./edit/MapKeys";
import { MapMenu } from "./edit/MapMenu";
import { FieldOffer } from "./FieldOffer";
import { FlightFigures } from "./FlightFigures";
import { FlatMap } from "./flat/FlatMap";
import { LayersSection } from "./LayersSection";
import { Attribution } from "./layers/Attribution";
import { MapDrop } from "./layers/MapDrop";
import { MapCorner } from "./MapCorner";
import { OnlineSection } from "./OnlineSection";
import { PatternSection } from "./PatternSection";
import { PlanSection } from "./PlanSection";
import { ProfileSection } from "./ProfileSection";
import { FlyHere } from "./plan/FlyHere";
import { PlanHazards } from "./profile/PlanHazards";
import { GlobeMissing } from "./scenes/GlobeMissing";
import { FlatContext, useMapKind } from "./scenes/useFlat";
import { GlobeContext } from "./scenes/useGlobe";
import { useKeptGlobe } from "./scenes/useKeptGlobe";
import { SurroundingsOnMap } from "./surroundings/SurroundingsOnMap";
import { SurroundingsSection } from "./surroundings/SurroundingsSection";
import { ThingCard } from "./ThingCard";
import { ThingsSection } from "./ThingsSection";
import { ToolsSection } from "./ToolsSection";
import { TrackSection } from "./TrackSection";
import "./map.css";

/** "Mapa 3D": the globe with the flight, or the flat map instead, and the panel for both. */
export function MapView() {
  const { t } = useTranslation();
  const host = useRef<HTMLDivElement>(null);
  const picture = useRef<HTMLElement>(null);
  const isGlobeWanted = useMapKind() === "3d";
  const { globe, problem, retry } = useKeptGlobe(host, isGlobeWanted);
  const [scene, setScene] = useState<FlatScene | null>(null);
  const isFlat = !isGlobeWanted || problem !== null;
  const flat = useMemo(() => ({ isShown: isFlat, scene }), [isFlat, scene]);
  return (
    <GlobeContext value={globe}>
      <FlatContext value={flat}>
        <div className="map">
          <div className="map-main">
            {isGlobeWanted && problem !== null && <GlobeMissing problem={problem} onRetry={retry} />}
            <section ref={picture} className="map-scene" aria-label={t("tab.map")}>
              {isGlobeWanted && (
                <div
                  ref={host}
                  className="map-host"
                  role="application"
                  aria-label={t("map.view.scene")}
                  hidden={isFlat}
                />
              )}
              {isFlat ? <FlatMap onScene={setScene} /> : <MapCorner />}
              <div className="map-over">
                <EditBar />
              </div>
              <FlightFigures />
              <SurroundingsOnMap />
              <PlanHazards plan="flight" />
              <PlanHazards plan="hil" />
              <MapKeys picture={picture} />
              <MapMenu />
              <FlyHere />
              <Attribution />
              <MapDrop />
            </section>
          </div>
          <div className="map-side">
            <ThingCard />
            <FieldOffer />
            <CameraSection />
            <ThingsSection />
            <AirfieldsSection />
            <TrackSection />
            <PlanSection />
            <PatternSection />
            <ProfileSection />
            <SurroundingsSection />
            <ToolsSection />
            <LayersSection />
            <OnlineSection />
          </div>
        </div>
      </FlatContext>
    </GlobeContext>
  );
}
