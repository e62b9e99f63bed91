import { BellOff, CheckCheck, Volume2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { formatClock } from "../lib/moment";
import { useActiveAlarms, useEndedAlarms, useMutedFor_s } from "../live/useAlarms";
import { usePage } from "../store/hooks";
import { choose } from "../store/settings";
import { AlarmStrip, endedWithoutPlace, LINES } from "../ui/AlarmStrip";
import { Button } from "../ui/Button";

/** What is wrong now, on every tab, with what can be done about it. */
export function Alarms() {
  const { t } = useTranslation();
  const { alarmBook, settings } = usePage();
  const alarms = useActiveAlarms();
  const open = alarms.filter(({ acknowledged }) => !acknowledged);
  const hidden = alarms.length - LINES;
  const ended = useEndedAlarms();
  const hiddenEnded = endedWithoutPlace(alarms.length, ended.length);
  const showList = (): void => choose(settings, "tab", "alarms");
  return (
    <AlarmStrip
      label={t("alarms.label")}
      alarms={alarms.map(({ id, level, text, acknowledged, since_s, blocked }) => ({
        id,
        level,
        text,
        acknowledged,
        detail: formatClock(since_s),
        blocked,
      }))}
      ended={{
        label: t("alarmBook.ended"),
        items: ended.map(({ id, level, name, until_s }) => ({
          id,
          level,
          text: name,
          detail: formatClock(until_s),
        })),
        acknowledge: {
          label: (text) => t("alarmBook.acknowledgeEnded", { text }),
          onPress: alarmBook.acknowledgeEnded,
        },
      }}
      acknowledge={{
        text: t("alarmBook.acknowledge"),
        label: (text) => t("alarmBook.acknowledgeOne", { text }),
        onPress: (id) => void alarmBook.acknowledge(id, { control: `acknowledge.${id}` }),
      }}
    >
      {hidden > 0 && (
        <Button onPress={showList} label={t("alarmBook.more", { count: hidden })}>
          {t("alarmBook.moreShort", { count: hidden })}
        </Button>
      )}
      {hiddenEnded > 0 && (
        <Button onPress={showList} label={t("alarmBook.moreEnded", { count: hiddenEnded })}>
          {t("alarmBook.moreEndedShort", { count: hiddenEnded })}
        </Button>
      )}
      {open.length + ended.length > 1 && (
        <Button
          onPress={() => void alarmBook.acknowledgeAll()}
          disabledReason={open[0]?.blocked}
          icon={<CheckCheck size={14} aria-hidden="true" />}
        >
          {t("alarmBook.acknowledgeAll")}
        </Button>
      )}
      {open.length > 0 && <MuteButton />}
    </AlarmStrip>
  );
}

/** Two minutes of silence; while they last, how many seconds are left, and sound again at a press. */
function MuteButton() {
  const { t } = useTranslation();
  const { alarmBook } = usePage();
  const muted_s = useMutedFor_s();
  return muted_s === null ? (
    <Button onPress={alarmBook.mute} icon={<BellOff size={14} aria-hidden="true" />}>
      {t("alarmBook.mute")}
    </Button>
  ) : (
    <Button onPress={alarmBook.unmute} icon={<Volume2 size={14} aria-hidden="true" />}>
      {t("alarmBook.muted", { seconds: muted_s })}
    </Button>
  );
}
