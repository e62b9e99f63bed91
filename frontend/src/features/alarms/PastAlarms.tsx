import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatAge } from "../../lib/format";
import { formatClock, formatMoment } from "../../lib/moment";
import { useConnection, usePage } from "../../store/hooks";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { type PastAlarm, pastAlarms } from "./alarmLog";
import { LevelMark } from "./LevelMark";
import { alarmMessage } from "./raisedAlarms";
import { useAlarmBook } from "./useAlarms";

/** What was wrong and is over. Read when the tab opens, and again whenever the gateway reports an alarm. */
export function PastAlarms() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { alarmBook } = usePage();
  const reported = useAlarmBook((state) => state.reported);
  const past = useAlarmBook((state) => state.past);
  const ownPast = useAlarmBook((state) => state.ownPast);
  const failure = useAlarmBook((state) => state.failure);
  const isOpen = useConnection(({ phase }) => phase === "open");
  // biome-ignore lint/correctness/useExhaustiveDependencies: each report makes the list out of date
  useEffect(() => {
    if (isOpen) {
      void alarmBook.readPast();
    }
  }, [alarmBook, isOpen, reported]);
  const alarms = pastAlarms({ past, ownPast });
  return (
    <Panel title={t("alarmBook.past")}>
      {failure !== null && <Notice level="warning">{sentence(failure)}</Notice>}
      {alarms.length === 0 ? (
        <p className="alarms-none">{past === null ? t("alarmBook.notRead") : t("alarmBook.noPast")}</p>
      ) : (
        <div className="alarms-table">
          <table>
            <thead>
              <tr>
                <th scope="col">{t("alarmBook.level")}</th>
                <th scope="col">{t("alarmBook.text")}</th>
                <th scope="col">{t("alarmBook.from")}</th>
                <th scope="col">{t("alarmBook.until")}</th>
                <th scope="col">{t("alarmBook.lasted")}</th>
                <th scope="col">{t("alarmBook.acknowledgedHead")}</th>
              </tr>
            </thead>
            <tbody>
              {alarms.map((alarm) => (
                <Row key={`${alarm.id}@${alarm.since_s}@${alarm.until_s}`} alarm={alarm} />
              ))}
            </tbody>
          </table>
        </div>
      )}
    </Panel>
  );
}

function Row({ alarm }: { alarm: PastAlarm }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const now_s = usePage().alarmBook.wall_s();
  return (
    <tr>
      <td>
        <LevelMark level={alarm.level} isBrief />
      </td>
      <td className="alarms-table-text">{sentence(alarmMessage(alarm, null))}</td>
      <td className="alarms-number">{formatMoment(alarm.since_s, now_s)}</td>
      <td className="alarms-number">{formatClock(alarm.until_s)}</td>
      <td className="alarms-number">{formatAge(alarm.until_s - alarm.since_s)}</td>
      <td>{alarm.acknowledged ? t("alarmBook.yes") : t("alarmBook.no")}</td>
    </tr>
  );
}
