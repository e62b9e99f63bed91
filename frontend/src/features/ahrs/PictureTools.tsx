import { useTranslation } from "react-i18next";
import type { CameraView } from "../../scene/attitude/OrbitRig";
import { useTelemetry } from "../../store/hooks";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { liveVectors } from "./source";

const VIEWS = [
  ["behind", "ahrs3d.from.behind"],
  ["front", "ahrs3d.from.front"],
  ["top", "ahrs3d.from.top"],
  ["side", "ahrs3d.from.side"],
] as const satisfies ReadonlyArray<readonly [CameraView, string]>;

interface Props {
  /** Null when the user turned it. */
  camera: CameraView | null;
  onCamera: (view: CameraView) => void;
  hasVectors: boolean;
}

/** Controls over the picture: the camera's views, and the legend of the arrows. */
export function PictureTools({ camera, onCamera, hasVectors }: Props) {
  const { t } = useTranslation();
  return (
    <div className="ahrs3d-tools">
      <SegmentedSwitch
        label={t("ahrs3d.camera")}
        hideLabel
        options={VIEWS.map(([view, word]) => ({ value: view, label: t(word) }))}
        value={camera}
        onChange={onCamera}
      />
      {hasVectors && <Legend />}
    </div>
  );
}

/** The values of the two arrows: their lengths in the picture are these. */
function Legend() {
  const { t } = useTranslation();
  const lengths = useTelemetry((telemetry, now_ms) => {
    const { acceleration_m_s2, field } = liveVectors(telemetry, now_ms);
    const length = (vector: readonly number[] | null, digits: number): string =>
      vector === null ? t("words.noData") : Math.hypot(...vector).toFixed(digits);
    return `${length(acceleration_m_s2, 1)}\n${length(field, 2)}`;
  });
  const [acceleration, field] = lengths.split("\n");
  return (
    <dl className="ahrs3d-legend">
      <div data-arrow="acceleration">
        <dt>{t("ahrs3d.legendAcceleration")}</dt>
        <dd className="app-number">{acceleration}</dd>
      </div>
      <div data-arrow="field">
        <dt>{t("ahrs3d.legendField")}</dt>
        <dd className="app-number">{field}</dd>
      </div>
    </dl>
  );
}
