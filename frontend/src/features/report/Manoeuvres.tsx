import { useTranslation } from "react-i18next";
import { formatFlightTime } from "../../lib/moment";
import type { FlightReport, ReportManoeuvre } from "../../protocol/guards.gen";
import { FigureLabel } from "./Define";
import { ANSWER, LEG, type ManoeuvreRow, MODEL, shown } from "./figures";
import { ManoeuvrePicture } from "./ManoeuvrePicture";

/** Each manoeuvre with its picture and figures, beside the like one of the other flight. */
export function Manoeuvres({ report }: { readonly report: FlightReport }) {
  const { t } = useTranslation();
  if (report.no_manoeuvres !== null) {
    return <p>{t(`report.why.${report.no_manoeuvres}`)}</p>;
  }
  return (
    <ol className="report-cards">
      {report.manoeuvres.map((one) => (
        <li key={`${one.kind} ${one.plan} ${one.at_s}`} className="report-card">
          <Card
            one={one}
            other={one.earlier === null ? null : (report.earlier?.manoeuvres[one.earlier] ?? null)}
            isCompared={report.earlier !== null}
          />
        </li>
      ))}
    </ol>
  );
}

interface CardProps {
  readonly one: ReportManoeuvre;
  readonly other: ReportManoeuvre | null;
  readonly isCompared: boolean;
}

function Card({ one, other, isCompared }: CardProps) {
  const { t } = useTranslation();
  const where = one.waypoint === null ? "" : ` · ${t("report.waypoint", { number: one.waypoint + 1 })}`;
  const isLeg = one.kind === "leg";
  return (
    <>
      <h4>
        {t(`report.kind.${one.kind}`)}
        <small>{` ${t("report.at_s", { at: formatFlightTime(one.at_s) })}${where}`}</small>
      </h4>
      <p className="report-quiet">{t(`report.cause.${one.cause}`)}</p>
      <div className="report-pictures">
        <ManoeuvrePicture one={one} />
        {other !== null && <ManoeuvrePicture one={other} />}
      </div>
      {!isLeg && one.method === "none" ? (
        <p className="report-quiet">{t("report.noFigures")}</p>
      ) : (
        <Figures one={one} other={other} rows={rowsOf(one, other)} />
      )}
      {one.is_cut && <p className="report-quiet">{t("report.cut")}</p>}
      {isCompared && other === null && <p className="report-quiet">{t("report.notInOther")}</p>}
    </>
  );
}

function rowsOf(one: ReportManoeuvre, other: ReportManoeuvre | null): readonly ManoeuvreRow[] {
  if (one.kind === "leg") {
    return LEG;
  }
  return one.model === null && (other?.model ?? null) === null ? ANSWER : [...ANSWER, ...MODEL];
}

interface FiguresProps {
  readonly one: ReportManoeuvre;
  readonly other: ReportManoeuvre | null;
  readonly rows: readonly ManoeuvreRow[];
}

function Figures({ one, other, rows }: FiguresProps) {
  const { t } = useTranslation();
  const across = ({ leg }: ReportManoeuvre): string =>
    t("report.acrossText", { rms: shown(leg?.across_rms_m, 0), most: shown(leg?.across_most_m, 0) });
  return (
    <table className="report-table">
      <thead>
        <tr>
          <th scope="col">{t("report.figure")}</th>
          <th scope="col">{t("report.this")}</th>
          {other !== null && <th scope="col">{t("report.otherShort")}</th>}
        </tr>
      </thead>
      <tbody>
        {rows.map(([name, read]) => (
          <tr key={name}>
            <th scope="row">
              <FigureLabel name={name} />
            </th>
            <td>{read(one, across(one))}</td>
            {other !== null && <td>{read(other, across(other))}</td>}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
