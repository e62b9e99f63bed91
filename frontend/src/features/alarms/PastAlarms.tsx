import { type ReactNode, useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatAge } from "../../lib/format";
import { formatClock, formatMoment } from "../../lib/moment";
import { useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
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
              {repeated(alarms).map((group) => (
                <Group key={group[0].id} alarms={group} />
              ))}
            </tbody>
          </table>
        </div>
      )}
    </Panel>
  );
}

type Repeated = readonly [PastAlarm, ...PastAlarm[]];

/** Those of one kind together, in the order in which the newest of each ended. */
function repeated(alarms: readonly PastAlarm[]): readonly Repeated[] {
  const groups = new Map<string, [PastAlarm, ...PastAlarm[]]>();
  for (const alarm of alarms) {
    const group = groups.get(alarm.id);
    if (group === undefined) groups.set(alarm.id, [alarm]);
    else group.push(alarm);
  }
  return [...groups.values()];
}

/** One line for an alarm that came again and again; a press shows each time. */
function Group({ alarms }: { alarms: Repeated }) {
  const { t } = useTranslation();
  const [isOpen, setOpen] = useState(false);
  const count = alarms.length;
  return (
    <>
      <Row alarms={alarms}>
        {count > 1 && (
          <Button onPress={() => setOpen(!isOpen)} pressed={isOpen} label={t("alarmLog.times", { count })}>
            {`× ${count}`}
          </Button>
        )}
      </Row>
      {isOpen && alarms.map((alarm) => <Row key={`${alarm.since_s}@${alarm.until_s}`} alarms={[alarm]} />)}
    </>
  );
}

/** Alarms of one kind, newest first, in one line: the words of the newest, from the first beginning to the last end. */
function Row({ alarms, children }: { alarms: Repeated; children?: ReactNode }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const now_s = usePart(ALARM_LOG).wall_s();
  const [newest] = alarms;
  const oldest = alarms.at(-1) ?? newest;
  const lasted_s = alarms.reduce((sum, { since_s, until_s }) => sum + until_s - since_s, 0);
  return (
    <tr>
      <td>
        <LevelMark
          level={alarms.some(({ level }) => level === "critical") ? "critical" : "warning"}
          isBrief
        />
      </td>
      <td className="alarms-table-text">
        {sentence(alarmMessage(newest, null))} {children}
      </td>
      <td className="alarms-number">{formatMoment(oldest.since_s, now_s)}</td>
      <td className="alarms-number">{formatClock(newest.until_s)}</td>
      <td className="alarms-number">{formatAge(lasted_s)}</td>
      <td>{alarms.every(({ acknowledged }) => acknowledged) ? t("alarmLog.yes") : t("alarmLog.no")}</td>
    </tr>
  );
}
