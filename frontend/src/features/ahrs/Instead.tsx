import { useTranslation } from "react-i18next";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { LiveHeading, type ReadLive } from "../../readouts/LiveHeading";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import type { AttitudeSource } from "./alignment";
import type { PictureProblem } from "./useStage";

interface Props {
  source: AttitudeSource;
  problem: PictureProblem;
  onRetry: () => void;
}

const HEADINGS: Readonly<Record<AttitudeSource, ReadLive>> = {
  ahrs: (telemetry, now_ms) => telemetry.liveNumber("ahrs", "yaw_deg", now_ms),
  ahrs_test: (telemetry, now_ms) => telemetry.liveNumber("ahrs_test", "yaw_deg", now_ms),
};
const PROBLEMS = {
  noWebgl: "ahrs3d.problem.noWebgl",
  lost: "ahrs3d.problem.lost",
  notLoaded: "ahrs3d.problem.notLoaded",
} as const satisfies Readonly<Record<PictureProblem, string>>;
const noBug: ReadLive = () => null;

/** Shown without WebGL: the reason, and the same attitude on two instruments that need none. */
export function Instead({ source, problem, onRetry }: Props) {
  const { t } = useTranslation();
  return (
    <div className="ahrs3d-instead">
      <Notice level="warning">
        <p>{t(PROBLEMS[problem])}</p>
        <Button onPress={onRetry}>{t("ahrs3d.retry")}</Button>
      </Notice>
      <div className="ahrs3d-instruments">
        <LiveAttitude topic={source} />
        <LiveHeading heading_deg={HEADINGS[source]} bearing_deg={noBug} />
      </div>
    </div>
  );
}
