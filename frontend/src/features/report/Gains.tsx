import { Fragment } from "react";
import { useTranslation } from "react-i18next";
import { formatFlightTime } from "../../lib/moment";
import type { FlightReport, ReportGain } from "../../protocol/guards.gen";
import { FigureLabel } from "./Define";
import { type FigureName, shown, withUnit } from "./figures";

const UNITS = { altitude: "ft", heading: "deg", speed: "kt" } as const;

/** Gains that were changed in flight, with their loop before and after; and those that differ from the other flight. */
export function Gains({ report }: { readonly report: FlightReport }) {
  const { t } = useTranslation();
  const differences = report.earlier?.gains ?? [];
  return (
    <>
      {report.gains.length === 0 && <p>{t("report.noGains")}</p>}
      {report.gains.map((gain) => (
        <Effect key={`${gain.name} ${gain.at_s}`} gain={gain} />
      ))}
      {differences.length > 0 && (
        <>
          <h4>{t("report.gainDifferences")}</h4>
          <dl className="report-list">
            {differences.map(({ name, before, after }) => (
              <Fragment key={name}>
                <dt>{name}</dt>
                <dd>{`${before} → ${after}`}</dd>
              </Fragment>
            ))}
          </dl>
        </>
      )}
    </>
  );
}

function Effect({ gain }: { readonly gain: ReportGain }) {
  const { t } = useTranslation();
  const { loop, earlier, later } = gain;
  const title = `${gain.name}: ${gain.before} → ${gain.after}`;
  const unit = loop === null ? "" : UNITS[loop];
  const rows: readonly (readonly [FigureName, (effect: NonNullable<typeof earlier>) => string])[] = [
    ["loopError", ({ error_rms }) => withUnit(error_rms, unit)],
    ["rise", ({ rise_s }) => shown(rise_s, 1, "s")],
    ["overshoot", ({ overshoot_percent }) => shown(overshoot_percent, 1, "%")],
    ["settling", ({ settling_s }) => shown(settling_s, 1, "s")],
    ["steady", ({ steady_error }) => withUnit(steady_error, unit)],
    ["damping", ({ damping }) => shown(damping, 2)],
  ];
  return (
    <section className="report-gain">
      <h4>
        {title}
        <small>{` ${t("report.at_s", { at: formatFlightTime(gain.at_s) })}`}</small>
      </h4>
      {loop !== null && earlier !== null && later !== null && (
        <table className="report-table">
          <thead>
            <tr>
              <th scope="col">{t(`report.loop.${loop}`)}</th>
              <th scope="col">{t("report.before")}</th>
              <th scope="col">{t("report.after")}</th>
            </tr>
          </thead>
          <tbody>
            <tr>
              <th scope="row">{t("report.count")}</th>
              <td>{earlier.manoeuvres}</td>
              <td>{later.manoeuvres}</td>
            </tr>
            {rows.map(([name, read]) => (
              <tr key={name}>
                <th scope="row">
                  <FigureLabel name={name} />
                </th>
                <td>{read(earlier)}</td>
                <td>{read(later)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </section>
  );
}
