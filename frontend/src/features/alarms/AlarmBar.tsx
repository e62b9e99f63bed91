import { CheckCheck } from "lucide-react";
import { useTranslation } from "react-i18next";
import { formatClock } from "../../lib/moment";
import { usePage, usePart } from "../../store/hooks";
import { choose } from "../../store/settings";
import { AlarmStrip, endedWithoutPlace, LINES } from "../../ui/AlarmStrip";
import { Button } from "../../ui/Button";
import { ALARM_LOG } from "./alarmLog";
import { MuteButton } from "./MuteButton";
import { withCount } from "./raisedAlarms";
import { blockedAmong, useActiveAlarms, useEndedAlarms } from "./useAlarms";

/** What is wrong now, on every tab, with what can be done about it. `isBesidePast`: all around it is the past. */
export function AlarmBar({ isBesidePast = false }: { readonly isBesidePast?: boolean }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const alarmLog = usePart(ALARM_LOG);
  const alarms = useActiveAlarms();
  const open = alarms.filter(({ acknowledged }) => !acknowledged);
  const hidden = alarms.length - LINES;
  const ended = useEndedAlarms();
  const hiddenEnded = endedWithoutPlace(alarms.length, ended.length);
  const showList = (): void => choose(settings, "tab", "alarms");
  return (
    <AlarmStrip
      label={t("alarms.label")}
      when={isBesidePast ? t("alarms.present") : undefined}
      quiet={t("alarmLog.none")}
      alarms={alarms.map(({ id, level, text, acknowledged, since_s, count, blocked }) => ({
        id,
        level,
        text,
        acknowledged,
        detail: withCount(formatClock(since_s), count),
        blocked,
      }))}
      ended={{
        label: t("alarmLog.ended"),
        items: ended.map(({ id, level, name, until_s, count, blocked }) => ({
          id,
          level,
          text: name,
          detail: withCount(formatClock(until_s), count),
          blocked,
        })),
        acknowledge: {
          label: (text) => t("alarmLog.acknowledgeEnded", { text }),
          onPress: (id) => void alarmLog.acknowledge(id, { control: `acknowledge.${id}` }),
        },
      }}
      acknowledge={{
        text: t("alarmLog.acknowledge"),
        label: (text) => t("alarmLog.acknowledgeOne", { text }),
        onPress: (id) => void alarmLog.acknowledge(id, { control: `acknowledge.${id}` }),
      }}
    >
      {hidden > 0 && (
        <Button onPress={showList} label={t("alarmLog.more", { count: hidden })}>
          {t("alarmLog.moreShort", { count: hidden })}
        </Button>
      )}
      {hiddenEnded > 0 && (
        <Button onPress={showList} label={t("alarmLog.moreEnded", { count: hiddenEnded })}>
          {/* Beside those that have a place the number alone is plain, and leaves them room in a narrow window. */}
          {t(alarms.length > 0 ? "alarmLog.moreEndedShort" : "alarmLog.moreShort", { count: hiddenEnded })}
        </Button>
      )}
      {open.length + ended.length > 1 && (
        <Button
          onPress={() => void alarmLog.acknowledgeAll()}
          disabledReason={blockedAmong([...open, ...ended])}
          icon={<CheckCheck size={14} aria-hidden="true" />}
        >
          {t("alarmLog.acknowledgeAll")}
        </Button>
      )}
      {open.length > 0 && <MuteButton />}
    </AlarmStrip>
  );
}
