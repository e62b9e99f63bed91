import { useState } from "react";
import { useTranslation } from "react-i18next";
import { ELLIPSOID_COVERAGE, type FieldFit, type FitRefusal, SPHERE_COVERAGE } from "../../lib/ellipsoid";
import { fitText, samplesCsv } from "../../lib/fieldSamples";
import { formatFixed } from "../../lib/format";
import { usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { copyText } from "../../ui/copyText";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { AHRS } from "./alignment";
import type { Calibration } from "./useCalibration";

const REFUSALS = {
  tooFew: "ahrs3d.refused.tooFew",
  notCovered: "ahrs3d.refused.notCovered",
  notClosed: "ahrs3d.refused.notClosed",
} as const satisfies Readonly<Record<FitRefusal, string>>;

const percent = (share: number): string => formatFixed(100 * share, 0) ?? "";

/** The fitted field in numbers, or why there is no fit; with buttons to copy and save it. */
export function FitPanel({ calibration }: { calibration: Calibration }) {
  const { t } = useTranslation();
  const { answer, fit, count } = calibration;
  return (
    <Panel title={t("ahrs3d.fit")}>
      {answer.kind === "refused" ? (
        <p role="status">{t(REFUSALS[answer.why], { least: percent(SPHERE_COVERAGE) })}</p>
      ) : (
        <FitNumbers fit={answer} />
      )}
      <FitTools fit={fit} count={count} />
    </Panel>
  );
}

const AXES = ["axis.x", "axis.y", "axis.z"] as const;

function FitNumbers({ fit }: { fit: FieldFit }) {
  const { t } = useTranslation();
  const { kind, offset, matrix, radius, residual, used, rejected } = fit;
  const three = (value: number): string => formatFixed(value, 3) ?? "";
  return (
    <>
      {kind === "sphere" && (
        <Notice level="info">{t("ahrs3d.sphereOnly", { least: percent(ELLIPSOID_COVERAGE) })}</Notice>
      )}
      <table className="ahrs3d-fit app-number">
        <caption className="visually-hidden">{t("ahrs3d.fit")}</caption>
        <thead>
          <tr>
            <td />
            <th scope="col">{t("ahrs3d.offset")}</th>
            <th scope="col">{t("ahrs3d.scale")}</th>
            <th scope="colgroup" colSpan={3}>
              {t("ahrs3d.softIron")}
            </th>
          </tr>
        </thead>
        <tbody>
          {AXES.map((axis, row) => (
            <tr key={axis}>
              <th scope="row">{t(axis)}</th>
              <td>{three(offset[row] ?? 0)}</td>
              <td>{three(matrix[row]?.[row] ?? 0)}</td>
              {AXES.map((other, column) => (
                <td key={other}>{three(matrix[row]?.[column] ?? 0)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      <p>
        {t("ahrs3d.quality", {
          field: three(radius),
          residual: formatFixed(residual, 4) ?? "",
          percent: formatFixed((100 * residual) / radius, 1) ?? "",
        })}
      </p>
      <p className="ahrs3d-aligned">{t("ahrs3d.usedReadings", { used, rejected })}</p>
    </>
  );
}

function FitTools({ fit, count }: { fit: FieldFit | null; count: number }) {
  const { t } = useTranslation();
  const { saveFile } = usePage();
  const ahrs3d = usePart(AHRS);
  const [copied, setCopied] = useState<"no" | "yes" | "failed">("no");
  return (
    <div className="ahrs3d-row">
      <Button
        onPress={() => {
          if (fit !== null) {
            void copyText(fitText(fit)).then((done) => setCopied(done ? "yes" : "failed"));
          }
        }}
        disabledReason={fit === null ? t("ahrs3d.nothingFitted") : undefined}
      >
        {t("ahrs3d.copy")}
      </Button>
      <Button
        onPress={() =>
          saveFile(
            "magnetometer.csv",
            new Blob([samplesCsv(ahrs3d.samples.points, fit)], { type: "text/csv" }),
          )
        }
        disabledReason={count === 0 ? t("ahrs3d.nothingCollected") : undefined}
      >
        {t("ahrs3d.save")}
      </Button>
      <p role="status" className="ahrs3d-aligned">
        {copied === "no" ? "" : t(copied === "yes" ? "ahrs3d.copied" : "ahrs3d.notCopied")}
      </p>
    </div>
  );
}
