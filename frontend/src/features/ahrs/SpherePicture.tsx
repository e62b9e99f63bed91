import { useCallback, useEffect, useId, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import type { Vector } from "../../lib/attitude";
import type { Palette } from "../../scene/attitude/palette";
import type { SphereScene } from "../../scene/attitude/SphereScene";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { AHRS } from "./alignment";
import type { Calibration } from "./useCalibration";
import { useStage } from "./useStage";

interface Props {
  calibration: Calibration;
  onReading: (listener: ((reading: Vector | null) => void) | null) => void;
}

type StageModule = typeof import("../../scene/attitude/keptStage");
const choose = (kept: StageModule): SphereScene => kept.keptSphere();

/** The readings in 3D. Without WebGL they are still collected and fitted. */
export function SpherePicture({ calibration, onReading }: Props) {
  const { t } = useTranslation();
  const { samples } = usePart(AHRS);
  const host = useRef<HTMLDivElement>(null);
  const hint = useId();
  const words = useMemo(
    () => ({ axisX: t("ahrs3d.axisX"), axisY: t("ahrs3d.axisY"), axisZ: t("ahrs3d.axisZ") }),
    [t],
  );
  const dress = useCallback((scene: SphereScene, palette: Palette) => scene.dress(palette, words), [words]);
  const { picture, problem, retry } = useStage(host, choose, dress);

  useEffect(() => {
    if (picture !== null) {
      const { fit, radius, centre, seen } = calibration;
      picture.act.show(samples.points, fit, radius, centre, seen);
      picture.stage.invalidate();
    }
  }, [picture, calibration, samples]);
  useEffect(() => {
    let before = "";
    onReading((reading) => {
      const text = reading === null ? "" : reading.map((value) => value.toFixed(3)).join();
      if (picture !== null && text !== before) {
        before = text;
        picture.act.point(reading);
        picture.stage.invalidate();
      }
    });
    return () => onReading(null);
  }, [picture, onReading]);

  return (
    <section className="ahrs3d-scene" aria-label={t("ahrs3d.sphere")}>
      <div
        ref={host}
        className="ahrs3d-host"
        data-has-picture={picture !== null}
        data-points={calibration.count}
        role="application"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: the camera is turned with the arrow keys
        tabIndex={0}
        aria-label={t("ahrs3d.sphereView")}
        aria-describedby={hint}
      />
      <p id={hint} className="ahrs3d-hint">
        {t("ahrs3d.hint")}
      </p>
      {problem !== null && (
        <div className="ahrs3d-instead">
          <Notice level="warning">
            <p>{t("ahrs3d.noSphere")}</p>
            <Button onPress={retry}>{t("ahrs3d.retry")}</Button>
          </Notice>
        </div>
      )}
    </section>
  );
}
