import { Crosshair, House, Maximize, ZoomIn, ZoomOut } from "lucide-react";
import { type ReactNode, useCallback, useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../../lib/aircraft";
import type { Position } from "../../../lib/geodesy";
import { roundLength } from "../../../lib/units";
import { useFlownAircraft } from "../../../readouts/flownAircraft";
import { coordinate } from "../../../readouts/formats";
import { useUnit } from "../../../readouts/useUnit";
import type { FlatScene } from "../../../scene/flat/FlatScene";
import { usePage, useSettings } from "../../../store/hooks";
import { choose } from "../../../store/settings";
import type { TelemetryStore } from "../../../store/telemetry";
import { usePaint } from "../../../store/usePaint";
import { Button } from "../../../ui/Button";
import { aircraftPlace } from "../aircraft/aircraftPlace";
import { flatAircraft } from "../aircraft/flatAircraft";
import { useHome } from "../aircraft/useHome";
import { useMapPlan } from "../plan/useMapPlan";
import { FOLLOW_CHOICE } from "../scenes/useFlat";
import { usePickAirfield } from "../scenes/useGroundNames";
import { useCovered } from "./useCovered";
import { useFlatContents } from "./useFlatContents";
import { useFlatScene } from "./useFlatScene";
import "../tools/tools.css";
import "./flat.css";

/** Drawing order: the last is on top. */
const DRAWN: readonly Aircraft[] = ["hil", "flight"];
/** Greatest length of the scale bar, pixels. */
const LONGEST_PX = 130;

interface Props {
  onScene: (scene: FlatScene | null) => void;
  /** The setting that stores whether it follows the aircraft; the map's own tab follows unless told otherwise. */
  followChoice?: typeof FOLLOW_CHOICE | "plans.map.follow";
  /** The only aircraft on it; undefined: both. */
  only?: Aircraft | undefined;
}

/**
 * The map without WebGL: the same flight from straight above. `onScene` is called with the scene, and with null when
 * it is gone.
 */
export function FlatMap({ onScene, followChoice = FOLLOW_CHOICE, only }: Props) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const canvas = useRef<HTMLCanvasElement>(null);
  const pointer = useRef<HTMLSpanElement>(null);
  const [pixel_m, setPixel_m] = useState(0);
  const contents = useFlatContents();
  const isFollowing = useSettings(
    ({ choices }) => (choices[followChoice] ?? (followChoice === FOLLOW_CHOICE ? "on" : "off")) === "on",
  );
  const follow = useCallback(
    (isOn: boolean) => choose(settings, followChoice, isOn ? "on" : "off"),
    [settings, followChoice],
  );
  const deg = t("unit.deg");
  const dash = t("words.dash");
  const scene = useFlatScene(canvas, {
    onScale: setPixel_m,
    onPointer: (place) => {
      if (pointer.current !== null) {
        pointer.current.textContent =
          place === null
            ? dash
            : `${coordinate(place.latitude_deg)}${deg} ${coordinate(place.longitude_deg)}${deg}`;
      }
    },
    onMoved: () => isFollowing && follow(false),
    onAirfield: usePickAirfield(),
  });
  useEffect(() => scene?.setContents(contents), [scene, contents]);
  useEffect(() => {
    onScene(scene);
    return () => onScene(null);
  }, [scene, onScene]);
  useAircraft(scene, isFollowing, only);
  useCovered(canvas, scene);
  return (
    <>
      <div
        className="map-flat"
        role="application"
        aria-label={t("map.flat.scene")}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: the map is moved by keys
        tabIndex={0}
        onKeyDown={(event) => {
          if (!(event.altKey || event.ctrlKey || event.metaKey) && scene?.key(event.key) === true) {
            event.preventDefault();
            event.stopPropagation();
          }
        }}
      >
        <canvas ref={canvas} />
      </div>
      <FlatButtons scene={scene} isFollowing={isFollowing} onFollow={follow} />
      <div className="map-legend">
        <FlatScale pixel_m={pixel_m} />
        <span className="map-pointer" role="img" aria-label={t("map.tools.pointer")}>
          <span ref={pointer}>{dash}</span>
        </span>
      </div>
    </>
  );
}

interface ButtonsProps {
  scene: FlatScene | null;
  isFollowing: boolean;
  onFollow: (isOn: boolean) => void;
}

function FlatButtons({ scene, isFollowing, onFollow }: ButtonsProps) {
  const { t } = useTranslation();
  const { telemetry } = usePage();
  const home = useHome();
  const flight = useMapPlan("flight");
  const hil = useMapPlan("hil");
  function show(places: readonly Position[]): void {
    onFollow(false);
    scene?.lookAt(places);
  }
  function everything(): readonly Position[] {
    const aircraft = DRAWN.map((plan) => aircraftPlace(telemetry, plan)).filter((place) => place !== null);
    return [...flight.waypoints, ...hil.waypoints, ...aircraft, home];
  }
  const button = (label: string, icon: ReactNode, onPress: () => void, pressed?: boolean) => (
    <Button onPress={onPress} icon={icon} label={label} pressed={pressed}>
      {null}
    </Button>
  );
  const look = { size: 16, "aria-hidden": true } as const;
  return (
    <div className="map-views" role="toolbar" aria-label={t("map.tools.views")}>
      {button(t("map.flat.nearer"), <ZoomIn {...look} />, () => scene?.zoom(1))}
      {button(t("map.flat.farther"), <ZoomOut {...look} />, () => scene?.zoom(-1))}
      {button(t("map.flat.follow"), <Crosshair {...look} />, () => onFollow(!isFollowing), isFollowing)}
      {button(t("map.tools.goHome"), <House {...look} />, () => show([home]))}
      {button(t("map.tools.showAll"), <Maximize {...look} />, () => show(everything()))}
    </div>
  );
}

/** Both aircraft, ten times a second. */
function useAircraft(scene: FlatScene | null, isFollowing: boolean, only: Aircraft | undefined): void {
  const { t } = useTranslation();
  const followed = useFlownAircraft();
  const flight = t("map.view.flight");
  const hil = t("map.view.hil");
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const names: Readonly<Record<Aircraft, string>> = { flight, hil };
      const shown = DRAWN.filter((plan) => only === undefined || plan === only);
      const seen = shown
        .map((plan) => flatAircraft(telemetry, plan, names[plan], now_ms))
        .filter((aircraft) => aircraft !== null);
      const middle = isFollowing ? seen.find(({ plan }) => plan === followed)?.place : undefined;
      scene?.setAircraft(seen, middle ?? null);
    },
    [scene, isFollowing, only, followed, flight, hil],
  );
  usePaint("text", paint);
}

/** The longest bar of a round length in the user's unit. */
function FlatScale({ pixel_m }: { pixel_m: number }) {
  const distance = useUnit("distance");
  if (pixel_m === 0) {
    return null;
  }
  const length = roundLength(distance.convert(pixel_m * LONGEST_PX));
  return (
    <span className="map-scale-bar">
      <span>{`${Number(length.toPrecision(3))} ${distance.label}`}</span>
      <span className="map-scale-line" style={{ width: `${distance.revert(length) / pixel_m}px` }} />
    </span>
  );
}
