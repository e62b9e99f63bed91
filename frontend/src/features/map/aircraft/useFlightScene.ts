import { useCallback, useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { AIRCRAFT } from "../../../lib/aircraft";
import { CAMERA_CHOICE, type CameraMode, cameraOf } from "../../../lib/mapCamera";
import { useFlownAircraft } from "../../../readouts/flownAircraft";
import type { FlightScene } from "../../../scene/aircraft/FlightScene";
import { usePage, usePart, useSettings } from "../../../store/hooks";
import type { TelemetryStore } from "../../../store/telemetry";
import { usePaint } from "../../../store/usePaint";
import { useGlobe, useGlobeLayer } from "../scenes/useGlobe";
import { TRACK_LOG } from "../track/trackLog";
import { AircraftMotion } from "./aircraftFeed";

/** The chosen camera mode. */
export function useCameraMode(): CameraMode {
  return useSettings(({ choices }) => cameraOf(choices[CAMERA_CHOICE]));
}

/** Shows both aircraft on the globe, moves the camera as chosen, and draws the tracks up to the aircraft. */
export function useFlightScene(): FlightScene | null {
  const { t } = useTranslation();
  const { telemetry } = usePage();
  const trackLog = usePart(TRACK_LOG);
  const globe = useGlobe();
  const scene = useGlobeLayer(
    "flight",
    async () => (await import("../../../scene/aircraft/FlightScene")).FlightScene,
  );
  const track = useGlobeLayer(
    "track",
    async () => (await import("../../../scene/track/TrackLayer")).TrackLayer,
  );
  const mode = useCameraMode();
  const followed = useFlownAircraft();
  const motion = useMemo(() => new AircraftMotion(), []);
  const take = useCallback((from: TelemetryStore, now_ms: number) => motion.take(from, now_ms), [motion]);
  usePaint("movement", take);
  const flight = t("map.view.flight");
  const hil = t("map.view.hil");
  useEffect(() => {
    scene?.aircraft.setFeed((now_ms) => motion.seen(telemetry, { flight, hil }, now_ms));
    return () => scene?.aircraft.setFeed(null);
  }, [scene, motion, telemetry, flight, hil]);
  useEffect(() => scene?.camera.set(mode, followed), [scene, mode, followed]);
  useEffect(() => {
    if (globe === null || scene === null || track === null) {
      return undefined;
    }
    return globe.onBeforePicture(() => {
      for (const aircraft of AIRCRAFT) {
        const seen = scene.aircraft.seen(aircraft);
        track.setTip(
          trackLog.points[aircraft],
          seen?.isLive === true ? { ...seen.place, t_s: seen.t_s } : null,
        );
      }
    });
  }, [globe, scene, track, trackLog]);
  return scene;
}
