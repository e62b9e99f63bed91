import { useState } from "react";
import { useTranslation } from "react-i18next";
import { formatMoment } from "../../lib/moment";
import type { JournalEntry } from "../../protocol/contract";
import { useConnection } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Panel } from "../../ui/Panel";
import { StateMark } from "../../ui/StateMark";
import { useParameters } from "./parameterValues";

/** As many as one looks at; the others come at a press. */
const FIRST = 20;

/** Who wrote what when, newest first. */
export function Journal() {
  const { t } = useTranslation();
  const entries = useParameters(({ journal }) => journal?.entries ?? null);
  const [isWhole, setWhole] = useState(false);
  if (entries === null) {
    return null;
  }
  const shown = isWhole ? entries : entries.slice(0, FIRST);
  return (
    <Panel title={t("paramJournal.title")} className="params-journal">
      {entries.length === 0 ? (
        <p>{t("paramJournal.empty")}</p>
      ) : (
        <table className="params-table">
          <caption className="visually-hidden">{t("paramJournal.title")}</caption>
          <thead>
            <tr>
              <th scope="col">{t("paramJournal.when")}</th>
              <th scope="col">{t("paramJournal.who")}</th>
              <th scope="col">{t("paramJournal.what")}</th>
              <th scope="col">{t("paramJournal.result")}</th>
            </tr>
          </thead>
          <tbody>
            {shown.map((entry) => (
              <Entry key={entry.id} entry={entry} />
            ))}
          </tbody>
        </table>
      )}
      {shown.length < entries.length && (
        <Button onPress={() => setWhole(true)}>
          {t("paramJournal.more", { count: entries.length - shown.length })}
        </Button>
      )}
    </Panel>
  );
}

function Entry({ entry }: { entry: JournalEntry }) {
  const { t } = useTranslation();
  const client = useConnection((connection) => connection.client);
  const who =
    entry.client === null
      ? t("paramJournal.nobody")
      : entry.client === client
        ? t("paramJournal.mine")
        : (entry.name ?? entry.client);
  return (
    <tr>
      <td className="params-figure">{formatMoment(entry.t_s, Date.now() / 1000)}</td>
      <td>{who}</td>
      <td>
        {t(`paramJournal.${entry.kind}`)}{" "}
        <span className="params-moves">
          {entry.changes
            .map(({ name, before, after }) =>
              t("params.move", { name, before: before ?? t("paramJournal.unknownBefore"), after }),
            )
            .join(", ")}
        </span>
      </td>
      <td>
        <span className="params-result">
          <StateMark state={entry.state} />
          {t(`paramOutcome.${entry.state}`)}
        </span>
      </td>
    </tr>
  );
}
