import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatAge } from "../../lib/format";
import { formatClock, formatMoment } from "../../lib/moment";
import { useConnection, usePart } from "../../store/hooks";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { ALARM_LOG, type PastAlarm, pastAlarms } from "./alarmLog";
import { LevelMark } from "./LevelMark";
import { alarmMessage } from "./raisedAlarms";
import { useAlarmLogState } from "./useAlarms";

/** Past alarms. Read when the tab opens, and again whenever the gateway reports an alarm. */
export function PastAlarms() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const alarmLog = usePart(ALARM_LOG);
  const reported = useAlarmLogState((state) => state.reported);
  const past = useAlarmLogState((state) => state.past);
  const ownPast = useAlarmLogState((state) => state.ownPast);
  const failure = useAlarmLogState((state) => state.failure);
  const isOpen = useConnection(({ phase }) => phase === "open");
  // biome-ignore lint/correctness/useExhaustiveDependencies: each report makes the list out of date
  useEffect(() => {
    if (isOpen) {
      void alarmLog.readPast();
    }
  }, [alarmLog, isOpen, reported]);
  const alarms = pastAlarms({ past, ownPast });
  return (
    <Panel title={t("alarmLog.past")}>
      {failure !== null && <Notice level="warning">{sentence(failure)}</Notice>}
      {alarms.length === 0 ? (
        <p className="alarms-none">{past === null ? t("alarmLog.notRead") : t("alarmLog.noPast")}</p>
      ) : (
        <div className="alarms-table">
          <table>
            <thead>
              <tr>
                <th scope="col">{t("alarmLog.level")}</th>
                <th scope="col">{t("alarmLog.text")}</th>
                <th scope="col">{t("alarmLog.from")}</th>
                <th scope="col">{t("alarmLog.until")}</th>
                <th scope="col">{t("alarmLog.lasted")}</th>
                <th scope="col">{t("alarmLog.acknowledgedHead")}</th>
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
  const now_s = usePart(ALARM_LOG).wall_s();
  return (
    <tr>
      <td>
        <LevelMark level={alarm.level} isBrief />
      </td>
      <td className="alarms-table-text">{sentence(alarmMessage(alarm, null))}</td>
      <td className="alarms-number">{formatMoment(alarm.since_s, now_s)}</td>
      <td className="alarms-number">{formatClock(alarm.until_s)}</td>
      <td className="alarms-number">{formatAge(alarm.until_s - alarm.since_s)}</td>
      <td>{alarm.acknowledged ? t("alarmLog.yes") : t("alarmLog.no")}</td>
    </tr>
  );
}
