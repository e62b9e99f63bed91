import { useCallback, useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { AIRCRAFT, type Aircraft } from "../../lib/aircraft";
import { formatFixed, formatHeading } from "../../lib/format";
import { CAMERA_CHOICE, CAMERAS } from "../../lib/mapCamera";
import { FOLLOWED_CHOICE, useFlownAircraft } from "../../readouts/flownAircraft";
import type { FlightScene } from "../../scene/aircraft/FlightScene";
import { LIGHTS } from "../../scene/look";
import { usePage, useTelemetry } from "../../store/hooks";
import { choose } from "../../store/settings";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Checkbox } from "../../ui/Checkbox";
import { Readout, ReadoutGrid, type ReadoutHandle } from "../../ui/Readout";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { useWords } from "../../ui/words";
import { type AircraftState, showing } from "./aircraft/aircraftFeed";
import { useCameraMode, useFlightScene } from "./aircraft/useFlightScene";
import { FoldingPanel } from "./panels/FoldingPanel";
import { KIND_CHOICE, KINDS, useFlat, useMapKind } from "./scenes/useFlat";
import { useGlobe } from "./scenes/useGlobe";
import { GRATICULE_CHOICE, useGraticule } from "./scenes/useGraticule";
import { LIGHT_CHOICE, useGlobeNames, useLight } from "./scenes/useGroundNames";

/** Which map is seen and where from, and which aircraft are on it or why not. */
export function CameraSection() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const globe = useGlobe();
  const flat = useFlat();
  const kind = useMapKind();
  const scene = useFlightScene();
  const mode = useCameraMode();
  const followed = useFlownAircraft();
  const graticule = useGraticule();
  const kinds = { "3d": t("map.flat.kind3d"), "2d": t("map.flat.kind2d") };
  const cameras = { follow: t("map.view.follow"), free: t("map.view.free"), cockpit: t("map.view.cockpit") };
  const names = { flight: t("map.view.flight"), hil: t("map.view.hil") };
  const light = useLight();
  const lights = { day: t("map.view.day"), night: t("map.view.night") };
  useEffect(() => globe?.ground.setGraticule(graticule !== null), [globe, graticule]);
  useEffect(() => globe?.ground.setLight(light), [globe, light]);
  useGlobeNames();
  useKeys(scene);
  return (
    <FoldingPanel name="camera" title={t("map.view.camera")} className="map-camera">
      <SegmentedSwitch
        label={t("map.flat.kind")}
        hideLabel
        options={KINDS.map((value) => ({ value, label: kinds[value] }))}
        value={kind}
        onChange={(value) => choose(settings, KIND_CHOICE, value)}
      />
      {!flat.isShown && (
        <SegmentedSwitch
          label={t("map.view.camera")}
          hideLabel
          options={CAMERAS.map((value) => ({ value, label: cameras[value] }))}
          value={mode}
          onChange={(value) => choose(settings, CAMERA_CHOICE, value)}
        />
      )}
      <SegmentedSwitch
        label={t("map.view.followed")}
        options={AIRCRAFT.map((value) => ({ value, label: names[value] }))}
        value={followed}
        onChange={(value) => choose(settings, FOLLOWED_CHOICE, value)}
        disabledReason={mode === "free" && !flat.isShown ? t("map.view.followedFree") : undefined}
      />
      {AIRCRAFT.map((aircraft) => (
        <HowShown key={aircraft} aircraft={aircraft} name={names[aircraft]} />
      ))}
      {!flat.isShown && <Eye scene={scene} />}
      {!flat.isShown && globe?.isSoftware === true && <p className="map-how">{t("map.view.software")}</p>}
      <SegmentedSwitch
        label={t("map.view.light")}
        options={LIGHTS.map((value) => ({ value, label: lights[value] }))}
        value={light}
        onChange={(value) => choose(settings, LIGHT_CHOICE, value)}
      />
      <Checkbox
        label={t("map.view.graticule")}
        checked={graticule !== null}
        onChange={(checked) => choose(settings, GRATICULE_CHOICE, checked ? "on" : "off")}
      />
      {globe === null && !flat.isShown && <p>{t("map.view.loading")}</p>}
    </FoldingPanel>
  );
}

/** The camera's direction and height, and how often the globe is drawn. */
function Eye({ scene }: { scene: FlightScene | null }) {
  const { t } = useTranslation();
  const globe = useGlobe();
  const heading = useRef<ReadoutHandle>(null);
  const pitch = useRef<ReadoutHandle>(null);
  const roll = useRef<ReadoutHandle>(null);
  const rate = useRef<ReadoutHandle>(null);
  const counted = useRef({ drawn: 0, at_ms: 0 });
  const paint = useCallback(
    (_: TelemetryStore, now_ms: number) => {
      const [heading_deg, pitch_deg, roll_deg] = scene?.camera.attitude_deg ?? [null, null, null];
      heading.current?.paint(formatHeading(heading_deg, 1), "live");
      pitch.current?.paint(formatFixed(pitch_deg, 1), "live");
      roll.current?.paint(formatFixed(roll_deg === null ? null : signed(roll_deg), 1), "live");
      const { drawn, at_ms } = counted.current;
      const passed_s = (now_ms - at_ms) / 1000;
      if (globe !== null && passed_s >= 1) {
        rate.current?.paint(formatFixed((globe.drawn - drawn) / passed_s, 0), "live");
        counted.current = { drawn: globe.drawn, at_ms: now_ms };
      }
    },
    [scene, globe],
  );
  usePaint("text", paint);
  return (
    <ReadoutGrid columns={1}>
      <Readout ref={heading} label={t("map.view.eyeHeading")} unit={t("unit.deg")} chars={5} />
      <Readout ref={pitch} label={t("map.view.eyePitch")} unit={t("unit.deg")} chars={5} />
      <Readout ref={roll} label={t("map.view.eyeRoll")} unit={t("unit.deg")} chars={5} />
      <Readout ref={rate} label={t("map.view.drawn")} unit={t("map.view.perSecond")} chars={3} />
    </ReadoutGrid>
  );
}

/** One line per aircraft: live, a ghost, or why it is not drawn. */
function HowShown({ aircraft, name }: { aircraft: Aircraft; name: string }) {
  const { t } = useTranslation();
  const { live } = useWords();
  const how: AircraftState = useTelemetry((telemetry, now_ms) => showing(telemetry, aircraft, now_ms));
  const reason = {
    live,
    stale: t("map.view.ghost"),
    noAttitude: t("map.view.noAttitude"),
    noPosition: t("map.view.noPosition"),
    notHeard: aircraft === "flight" ? t("map.view.notHeard") : t("map.view.notHeardHil"),
  }[how];
  return (
    <p className="map-how" data-how={how}>
      {t("map.view.how", { name, reason })}
    </p>
  );
}

/** The keys of the globe, while it has the focus. */
function useKeys(scene: FlightScene | null): void {
  const globe = useGlobe();
  useEffect(() => {
    const host = globe?.host;
    if (scene === null || host == null) {
      return undefined;
    }
    const press = (event: KeyboardEvent): void => {
      if (!(event.altKey || event.ctrlKey || event.metaKey) && scene.camera.key(event.key)) {
        event.preventDefault();
        event.stopPropagation();
      }
    };
    host.addEventListener("keydown", press);
    return () => host.removeEventListener("keydown", press);
  }, [globe, scene]);
}

/** An angle of 0..360 as -180..180. */
function signed(angle_deg: number): number {
  return angle_deg > 180 ? angle_deg - 360 : angle_deg;
}
