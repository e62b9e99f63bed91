import { Download, Search, X } from "lucide-react";
import { useEffect, useId, useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { formatDateTime, formatMoment } from "../../lib/moment";
import { useConnection, usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Select } from "../../ui/Select";
import { FLIGHT_LOG, LOG_GROUPS, type LogGroup } from "./flightLog";
import { EVERYTHING, filtered, LEVELS, type LogFilter, type LogRow, logFile, logRows } from "./logRows";
import "./log.css";

/** The browser stays quick with this many; the others follow on demand. */
const FIRST = 200;

/** Everything that was said and that happened in the flight in progress, newest first. */
export function LogContent() {
  const { t } = useTranslation();
  const [filter, setFilter] = useState<LogFilter>(EVERYTHING);
  const [most, setMost] = useState(FIRST);
  const failure = useStore(usePart(FLIGHT_LOG).store, (state) => state.failure);
  const sentence = useSentence();
  const isRecording = useConnection(({ status }) => status?.recording.active === true);
  const rows = useRows();
  const shown = useMemo(() => filtered(rows, filter), [rows, filter]);
  const there = LOG_GROUPS.filter((group) => rows.some((row) => row.group === group));
  const change = (part: Partial<LogFilter>): void => setFilter({ ...filter, ...part });
  return (
    <div className="log">
      <search className="log-filters">
        <SearchField text={filter.search} onChange={(search) => change({ search })} />
        <Select
          label={t("log.least")}
          placeholder={t("log.least")}
          value={filter.least}
          options={LEVELS.map((value) => ({ value, label: t(`logLevel.${value}`) }))}
          onChange={(least) => change({ least })}
        />
        <fieldset className="log-groups">
          <legend className="visually-hidden">{t("log.groups")}</legend>
          {there.map((group) => (
            <Button
              key={group}
              pressed={!filter.hidden.includes(group)}
              onPress={() => change({ hidden: toggled(filter.hidden, group) })}
            >
              {t(`logGroup.${group}`)}
            </Button>
          ))}
        </fieldset>
        {filter !== EVERYTHING && (
          <Button onPress={() => setFilter(EVERYTHING)} icon={<X size={14} aria-hidden="true" />}>
            {t("log.all")}
          </Button>
        )}
        <SaveButton rows={shown} />
        <span className="log-quiet" role="status">
          {t("log.shown", { count: shown.length })}
        </span>
      </search>
      {failure !== null && <Notice level="warning">{sentence(failure)}</Notice>}
      {!isRecording && <p className="log-quiet">{t("log.notRecorded")}</p>}
      <Lines rows={shown.slice(0, most)} isFiltered={rows.length > 0} />
      {shown.length > most && (
        <Button onPress={() => setMost(most + 5 * FIRST)}>
          {t("log.more", { count: shown.length - most })}
        </Button>
      )}
    </div>
  );
}

function useRows(): readonly LogRow[] {
  const flightLog = usePart(FLIGHT_LOG);
  const sentence = useSentence();
  const kept = useStore(usePage().messages, (state) => state.kept);
  const events = useStore(flightLog.store, (state) => state.events);
  useEffect(() => flightLog.watch(), [flightLog]);
  return useMemo(
    () => logRows(kept, events ?? [], flightLog.tell, sentence),
    [kept, events, flightLog, sentence],
  );
}

function SearchField({ text, onChange }: { text: string; onChange: (text: string) => void }) {
  const { t } = useTranslation();
  const id = useId();
  return (
    <div className="ui-field log-search">
      <label htmlFor={id} className="ui-field-label">
        {t("log.searchShort")}
      </label>
      <span className="ui-field-box">
        <Search size={14} aria-hidden="true" className="log-search-icon" />
        <input
          id={id}
          type="search"
          className="ui-field-input log-search-input"
          autoComplete="off"
          maxLength={200}
          aria-label={t("log.search")}
          value={text}
          onChange={(event) => onChange(event.currentTarget.value)}
        />
      </span>
    </div>
  );
}

function Lines({ rows, isFiltered }: { rows: readonly LogRow[]; isFiltered: boolean }) {
  const { t } = useTranslation();
  if (rows.length === 0) {
    return <p className="log-quiet">{t(isFiltered ? "log.noneFound" : "log.none")}</p>;
  }
  return (
    <ol className="log-lines" aria-label={t("log.lines")}>
      {rows.map((row) => (
        <Line key={row.key} row={row} />
      ))}
    </ol>
  );
}

function Line({ row: { at_s, group, level, text } }: { row: LogRow }) {
  const { t } = useTranslation();
  return (
    <li className="log-line" data-level={level}>
      <time className="log-time" dateTime={new Date(at_s * 1000).toISOString()}>
        {formatMoment(at_s, Date.now() / 1000)}
      </time>
      <span className="log-group">{t(`logGroup.${group}`)}</span>
      <span className="log-text">
        {level !== "info" && <strong className="log-level">{t(`logLine.${level}`)}</strong>}
        {text}
      </span>
    </li>
  );
}

function SaveButton({ rows }: { rows: readonly LogRow[] }) {
  const { t } = useTranslation();
  const { saveFile } = usePage();
  return (
    <Button
      icon={<Download size={14} aria-hidden="true" />}
      onPress={() => {
        const text = logFile(rows, {
          time: formatDateTime,
          level: (level) => t(`logLine.${level}`),
          group: (group) => t(`logGroup.${group}`),
        });
        saveFile("epf-gcs-log.txt", new Blob([text], { type: "text/plain;charset=utf-8" }));
      }}
    >
      {t("log.save")}
    </Button>
  );
}

function toggled(hidden: readonly LogGroup[], group: LogGroup): readonly LogGroup[] {
  return hidden.includes(group) ? hidden.filter((one) => one !== group) : [...hidden, group];
}
