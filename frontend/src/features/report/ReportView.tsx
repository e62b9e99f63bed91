import { ExternalLink, Printer, X } from "lucide-react";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { formatDateTime, formatFlightTime } from "../../lib/moment";
import type { FlightReport } from "../../protocol/guards.gen";
import { operatorName } from "../../requests/useControl";
import { usePart, useSettings } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Select } from "../../ui/Select";
import { Definitions, FigureLabel } from "./Define";
import { BATTERY, type FigureName, LINK, type Row, type Say, shown, TIMES, withUnit } from "./figures";
import { Gains } from "./Gains";
import { Manoeuvres } from "./Manoeuvres";
import { type OpenReport, REPORTS, reportPath } from "./reportRequests";
import "./report.css";

/** A flight that can be set beside the report's. */
export interface Choice {
  readonly id: string;
  readonly name: string;
}

interface Props {
  /** What the flight is called. */
  readonly name: string;
  readonly others: readonly Choice[];
}

/** The report that is open; nothing while none is. */
export function ReportView(props: Props) {
  const open = useStore(usePart(REPORTS).store);
  return open === null ? null : <Opened {...props} open={open} />;
}

const NO_FLIGHT = "none";

function Opened({ name, others, open }: Props & { readonly open: OpenReport }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const reports = usePart(REPORTS);
  const language = useSettings((settings) => settings.language);
  const { flight, compare, report, problem, isWorking } = open;
  const choices = others
    .filter(({ id }) => id !== flight)
    .map(({ id, name: label }) => ({ value: id, label }));
  return (
    <section className="report" aria-label={t("report.title")} aria-busy={isWorking}>
      <div className="report-tools">
        <Button onPress={reports.close} icon={<X size={15} aria-hidden="true" />}>
          {t("report.close")}
        </Button>
        <Select
          label={t("report.compareWith")}
          options={[{ value: NO_FLIGHT, label: t("report.noCompare") }, ...choices]}
          value={compare ?? NO_FLIGHT}
          onChange={(id) => reports.open(flight, id === NO_FLIGHT ? null : id)}
          placeholder={t("report.noCompare")}
        />
        <Button onPress={() => window.print()} icon={<Printer size={15} aria-hidden="true" />}>
          {t("report.print")}
        </Button>
        <a
          className="report-page"
          href={reportPath(flight, compare, language)}
          target="_blank"
          rel="noreferrer"
        >
          <ExternalLink size={15} aria-hidden="true" /> {t("report.page")}
        </a>
      </div>
      {isWorking && <p role="status">{t("report.working")}</p>}
      {problem !== null && (
        <>
          <Notice level="error">{sentence(failureMessage(problem))}</Notice>
          <Button onPress={() => reports.open(flight, compare)}>{t("report.retry")}</Button>
        </>
      )}
      {report !== null && (
        <Definitions>
          <Report name={name} report={report} />
        </Definitions>
      )}
    </section>
  );
}

function Report({ name, report }: { readonly name: string; readonly report: FlightReport }) {
  const begun = formatDateTime(report.times.started_s);
  const { t } = useTranslation();
  const { identity, battery, alarms, marks } = report;
  const facts = [
    identity.aircraft,
    identity.board,
    identity.firmware,
    operatorName(t, identity.operator),
    report.flight,
  ];
  return (
    <article className="report-sheet">
      <h2>{t("report.title")}</h2>
      <p className="report-name">{name === begun ? begun : `${name} · ${begun}`}</p>
      <p className="report-quiet">{facts.filter((fact) => fact !== null).join(" · ")}</p>
      <Section title={t("report.times")}>
        <Figures report={report} rows={TIMES} />
      </Section>
      {battery !== null && (
        <Section title={t("report.battery")}>
          <Figures report={report} rows={BATTERY} />
        </Section>
      )}
      <Section title={t("report.link")}>
        <Figures report={report} rows={LINK} />
      </Section>
      <Section title={t("report.alarms")}>
        {alarms.length === 0 ? <p>{t("report.noAlarms")}</p> : <Alarms report={report} />}
      </Section>
      {report.events.length > 0 && (
        <Section title={t("report.events")}>
          <ul>
            {report.events.map(({ kind, at_s, until_s, detail }) => (
              <li key={`${at_s} ${kind} ${detail}`}>
                {`${formatFlightTime(at_s)}  ${t(`report.event.${kind}`)}`}
                {detail === "" ? "" : `: ${detail}`}
                {until_s === null ? "" : ` (${shown(until_s - at_s, 1, "s")})`}
              </li>
            ))}
          </ul>
        </Section>
      )}
      {marks.length > 0 && (
        <Section title={t("report.marks")}>
          <ul>
            {marks.map(({ at_s, text }) => (
              <li key={`${at_s} ${text}`}>{`${formatFlightTime(at_s)}  ${text}`}</li>
            ))}
          </ul>
        </Section>
      )}
      {report.loops.length > 0 && (
        <Section title={t("report.loops")}>
          <Loops report={report} />
        </Section>
      )}
      <Section title={t("report.manoeuvres")}>
        <Manoeuvres report={report} />
      </Section>
      <Section title={t("report.gains")}>
        <Gains report={report} />
      </Section>
      <Section title={t("report.unknown")}>
        <ul>
          {report.unknown.map((word) => (
            <li key={word}>{t(`report.cannot.${word}`)}</li>
          ))}
        </ul>
      </Section>
    </article>
  );
}

function Section({ title, children }: { readonly title: string; readonly children: ReactNode }) {
  return (
    <section className="report-section">
      <h3>{title}</h3>
      {children}
    </section>
  );
}

function Figures({ report, rows }: { readonly report: FlightReport; readonly rows: readonly Row[] }) {
  const { t } = useTranslation();
  const { earlier } = report;
  const say: Say = (key, values) => String(t(`report.${key}`, values as never));
  return (
    <table className="report-table">
      {earlier !== null && (
        <thead>
          <tr>
            <th scope="col">{t("report.figure")}</th>
            <th scope="col">{t("report.this")}</th>
            <th scope="col">{t("report.other", { when: formatDateTime(earlier.times.started_s) })}</th>
          </tr>
        </thead>
      )}
      <tbody>
        {rows.map(([figure, read]) => (
          <tr key={figure}>
            <th scope="row">
              <FigureLabel name={figure} />
            </th>
            <td>{read(report, say)}</td>
            {earlier !== null && <td>{read(earlier, say)}</td>}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Alarms({ report: { alarms } }: { readonly report: FlightReport }) {
  const { t, i18n } = useTranslation();
  return (
    <ul>
      {alarms.map(({ name, at_s, lasted_s, count }) => (
        <li key={name}>
          {`${formatFlightTime(at_s)}  ${i18n.exists(`alarmName.${name}`) ? t(`alarmName.${name}` as never) : name}${count > 1 ? ` × ${count}` : ""}: ${
            lasted_s === null ? t("report.untilEnd") : shown(lasted_s, 1, "s")
          }`}
        </li>
      ))}
    </ul>
  );
}

const LOOP_FIGURES: readonly FigureName[] = ["rise", "overshoot", "settling", "steady", "damping"];

function Loops({ report: { loops, earlier } }: { readonly report: FlightReport }) {
  const { t } = useTranslation();
  return (
    <table className="report-table">
      <thead>
        <tr>
          <th scope="col">{t("report.kindColumn")}</th>
          <th scope="col">{t("report.count")}</th>
          {LOOP_FIGURES.map((name) => (
            <th key={name} scope="col">
              <FigureLabel name={name} />
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {loops.flatMap((one) => {
          const other = earlier?.loops.find(({ loop }) => loop === one.loop);
          return [one, ...(other === undefined ? [] : [other])].map((flown, index) => (
            <tr key={`${one.loop} ${index === 0 ? "this" : "other"}`}>
              <th scope="row">{index === 0 ? t(`report.loop.${one.loop}`) : t("report.otherShort")}</th>
              <td>{flown.manoeuvres}</td>
              <td>{shown(flown.rise_s, 1, "s")}</td>
              <td>{shown(flown.overshoot_percent, 1, "%")}</td>
              <td>{shown(flown.settling_s, 1, "s")}</td>
              <td>{withUnit(flown.steady_error, flown.unit)}</td>
              <td>{shown(flown.damping, 2)}</td>
            </tr>
          ));
        })}
      </tbody>
    </table>
  );
}
