import { type RefObject, useCallback, useEffect, useId, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatAge } from "../../lib/format";
import type { AttitudeScene, SceneWords } from "../../scene/attitude/AttitudeScene";
import type { CameraView } from "../../scene/attitude/OrbitRig";
import type { Palette } from "../../scene/attitude/palette";
import { useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { StaleCross } from "../../ui/StaleCross";
import type { AttitudeSource } from "./alignment";
import { useAlignment } from "./alignment";
import { AttitudeFeed, isWhole } from "./feed";
import { Instead } from "./Instead";
import { PictureTools } from "./PictureTools";
import { type StagePicture, useStage } from "./useStage";

export interface PictureSettings {
  readonly ghost: boolean;
  readonly bodyAxes: boolean;
  readonly worldAxes: boolean;
  readonly vectors: boolean;
  /** The camera turns with the heading. */
  readonly follow: boolean;
}

/**
 * The camera's named view, null when the user turned it; `pressed` counts the requests, so that the same view can be
 * chosen twice.
 */
export interface CameraChoice {
  readonly view: CameraView | null;
  readonly pressed: number;
}

interface Props {
  source: AttitudeSource;
  settings: PictureSettings;
  camera: CameraChoice;
  onCamera: (view: CameraView) => void;
  /** The user turned the camera away from a named view. */
  onFree: () => void;
}

type Picture = StagePicture<AttitudeScene>["picture"];
type StageModule = typeof import("../../scene/attitude/keptStage");
const choose = (kept: StageModule): AttitudeScene => kept.keptAttitude();

/** The aircraft in 3D, painted without a render; without WebGL the instruments stand in its place. */
export function AttitudePicture({ source, settings, camera, onCamera, onFree }: Props) {
  const { t } = useTranslation();
  const host = useRef<HTMLDivElement>(null);
  const hint = useId();
  const zero_deg = useAlignment((alignment) => alignment[source]);
  const words = useSceneWords();
  const dress = useCallback((scene: AttitudeScene, palette: Palette) => scene.dress(palette, words), [words]);
  const { picture, problem, retry } = useStage(host, choose, dress);

  useEffect(() => {
    if (picture !== null) {
      picture.act.setShown(settings);
      picture.act.setFollow(settings.follow);
      picture.act.setZero(zero_deg);
      picture.stage.invalidate();
    }
  }, [picture, settings, zero_deg]);
  useEffect(() => {
    if (picture !== null && camera.view !== null && camera.pressed >= 0) {
      picture.act.look(camera.view);
      picture.stage.invalidate();
    }
  }, [picture, camera]);
  useEffect(() => {
    if (picture === null) {
      return undefined;
    }
    picture.act.rig.onFree = onFree;
    return () => {
      picture.act.rig.onFree = null;
    };
  }, [picture, onFree]);

  usePaint("movement", useFeed(host, picture, source, camera.view));

  return (
    <section className="ahrs3d-scene" aria-label={t("ahrs3d.picture")}>
      <div
        ref={host}
        className="ahrs3d-host"
        data-has-picture={picture !== null}
        role="application"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: the camera is turned with the arrow keys
        tabIndex={0}
        aria-label={t("ahrs3d.view")}
        aria-describedby={hint}
      />
      {problem === null && <Age source={source} />}
      {problem === null && (
        <PictureTools camera={camera.view} onCamera={onCamera} hasVectors={settings.vectors} />
      )}
      {problem === null && (
        <p id={hint} className="ahrs3d-hint">
          {t("ahrs3d.hint")}
        </p>
      )}
      {problem !== null && <Instead source={source} problem={problem} onRetry={retry} />}
    </section>
  );
}

/** The cross and the age, drawn over data that is not live. */
function Age({ source }: { source: AttitudeSource }) {
  const { t } = useTranslation();
  const text = useTelemetry((telemetry, now_ms) => {
    if (isWhole(telemetry, source, now_ms)) {
      return null;
    }
    const age_s = telemetry.age_s(source, now_ms);
    return age_s === null ? "" : formatAge(age_s);
  });
  return (
    <StaleCross
      shown={text !== null}
      text={text === null || text === "" ? t("words.noData") : t("ahrs3d.stale", { age: text })}
    />
  );
}

/** Feeds the scene from the telemetry, and writes what it shows to its element's data attributes. */
function useFeed(
  host: RefObject<HTMLElement | null>,
  picture: Picture,
  source: AttitudeSource,
  view: CameraChoice["view"],
): (telemetry: TelemetryStore, now_ms: number) => void {
  const feed = useMemo(
    () => (picture === null ? null : new AttitudeFeed(picture.act, () => picture.stage.invalidate())),
    [picture],
  );
  const wanted = useRef(view);
  useEffect(() => {
    wanted.current = view;
  }, [view]);
  return useCallback(
    (telemetry, now_ms) => {
      if (picture !== null && feed !== null && host.current !== null) {
        feed.feed(telemetry, source, wanted.current, now_ms);
        feed.tell(host.current.dataset, picture.stage.drawn);
      }
    },
    [host, picture, feed, source],
  );
}

function useSceneWords(): SceneWords {
  const { t } = useTranslation();
  return useMemo(
    () => ({
      north: t("heading.north"),
      east: t("heading.east"),
      south: t("heading.south"),
      west: t("heading.west"),
      down: t("ahrs3d.down"),
      axisX: t("ahrs3d.axisX"),
      axisY: t("ahrs3d.axisY"),
      axisZ: t("ahrs3d.axisZ"),
      acceleration: t("ahrs3d.acceleration"),
      field: t("ahrs3d.field"),
      zero: "0°",
    }),
    [t],
  );
}
