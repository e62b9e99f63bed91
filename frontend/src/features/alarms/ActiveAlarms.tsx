import { CheckCheck, CircleCheck } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatAge } from "../../lib/format";
import { formatClock } from "../../lib/moment";
import { useHeightText } from "../../readouts/heightSets";
import { useAsked } from "../../requests/useAsked";
import { useConnection, usePage, usePart, useTelemetry } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Panel } from "../../ui/Panel";
import { ALARM_LOG } from "./alarmLog";
import { LevelMark } from "./LevelMark";
import { GATEWAY_LOST, withCount } from "./raisedAlarms";
import {
  type AlarmView,
  blockedAmong,
  type EndedAlarmView,
  useActiveAlarms,
  useEndedAlarms,
} from "./useAlarms";

const TERRAIN_AHEAD = "terrain_ahead";

/** The active alarms, each with its advice. */
export function ActiveAlarms() {
  const { t } = useTranslation();
  const alarmLog = usePart(ALARM_LOG);
  const alarms = useActiveAlarms();
  const open = alarms.filter(({ acknowledged }) => !acknowledged);
  const ended = useEndedAlarms();
  return (
    <Panel
      title={t("alarmLog.active")}
      actions={
        <Button
          onPress={() => void alarmLog.acknowledgeAll()}
          disabledReason={
            open.length + ended.length === 0 ? t("alarmLog.nothingOpen") : blockedAmong([...open, ...ended])
          }
          icon={<CheckCheck size={14} aria-hidden="true" />}
        >
          {t("alarmLog.acknowledgeAll")}
        </Button>
      }
    >
      {alarms.length === 0 && (
        <p className="alarms-none">
          <CircleCheck size={16} aria-hidden="true" />
          {ended.length === 0 ? t("alarmLog.none") : t("alarmLog.noneButEnded", { count: ended.length })}
        </p>
      )}
      {alarms.length + ended.length > 0 && (
        <ul className="alarms-active">
          {alarms.map((alarm) => (
            <Active key={alarm.id} alarm={alarm} />
          ))}
          {ended.map((alarm) => (
            <EndedUnseen key={`ended ${alarm.id}`} alarm={alarm} />
          ))}
        </ul>
      )}
    </Panel>
  );
}

function Active({ alarm }: { alarm: AlarmView }) {
  const { t } = useTranslation();
  const alarmLog = usePart(ALARM_LOG);
  const sentence = useSentence();
  const control = `acknowledge.${alarm.id}`;
  const { state, stateText } = useAsked(control);
  const advice = sentence({
    level: "info",
    key: `alarmAdvice.${alarm.id}`,
    params: {},
    fallback: t("alarmLog.noAdvice"),
  });
  return (
    <li className="alarms-item" data-level={alarm.level} data-acknowledged={alarm.acknowledged}>
      <LevelMark level={alarm.level} />
      <div className="alarms-item-text">
        <p className="alarms-item-title">{alarm.text}</p>
        <p className="alarms-item-advice">{advice}</p>
        {alarm.id === TERRAIN_AHEAD && <HeightsOfWarning />}
        <p className="alarms-item-since">
          <span>{t("alarmLog.since", { clock: withCount(formatClock(alarm.since_s), alarm.count) })}</span>
          <Lasting alarm={alarm} />
        </p>
      </div>
      {alarm.acknowledged ? (
        <span className="alarms-known">{t("alarmLog.acknowledged")}</span>
      ) : (
        <Button
          onPress={() => void alarmLog.acknowledge(alarm.id, { control })}
          state={state}
          stateText={stateText}
          disabledReason={alarm.blocked}
          label={t("alarmLog.acknowledgeOne", { text: alarm.text })}
        >
          {t("alarmLog.acknowledge")}
        </Button>
      )}
    </li>
  );
}

/** By which heights the station warns of the ground. */
function HeightsOfWarning() {
  const heightText = useHeightText();
  const surroundings = useConnection(({ status }) => status?.surroundings);
  const warned = surroundings === undefined ? [] : [surroundings.flight, surroundings.hil];
  const texts = warned.flatMap(({ terrain, heights }) => (terrain === null ? [] : heights.map(heightText)));
  return [...new Set(texts)].map((text) => (
    <p key={text} className="alarms-item-advice">
      {text}
    </p>
  ));
}

/** Ended without being acknowledged: shown until somebody acknowledges it. */
function EndedUnseen({ alarm: { id, level, name, until_s, count, blocked } }: { alarm: EndedAlarmView }) {
  const { t } = useTranslation();
  const alarmLog = usePart(ALARM_LOG);
  const control = `acknowledge.${id}`;
  const { state, stateText } = useAsked(control);
  return (
    <li className="alarms-item" data-level={level} data-acknowledged={true}>
      <LevelMark level={level} />
      <div className="alarms-item-text">
        <p className="alarms-item-title">{name}</p>
        <p className="alarms-item-since">
          {t("alarmLog.endedAt", { clock: withCount(formatClock(until_s), count) })}
        </p>
      </div>
      <Button
        onPress={() => void alarmLog.acknowledge(id, { control })}
        state={state}
        stateText={stateText}
        disabledReason={blocked}
        label={t("alarmLog.acknowledgeEnded", { text: name })}
      >
        {t("alarmLog.acknowledge")}
      </Button>
    </li>
  );
}

/** How long it has lasted, by the clock of the side that raised it. */
function Lasting({ alarm: { id, since_s } }: { alarm: AlarmView }) {
  const { connection } = usePage();
  const alarmLog = usePart(ALARM_LOG);
  const lasting = useTelemetry(() => {
    const server_s = connection.getState().status?.server_time_s ?? since_s;
    return formatAge((id === GATEWAY_LOST ? alarmLog.wall_s() : server_s) - since_s);
  });
  return <span className="alarms-number">{lasting}</span>;
}
