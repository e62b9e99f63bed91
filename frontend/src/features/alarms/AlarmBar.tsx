import { BellOff, CheckCheck, Volume2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { formatClock } from "../../lib/moment";
import { usePage } from "../../store/hooks";
import { choose } from "../../store/settings";
import { AlarmStrip, LINES } from "../../ui/AlarmStrip";
import { Button } from "../../ui/Button";
import { useActiveAlarms, useMutedFor_s } from "./useAlarms";

/** What is wrong now, on every tab, with what can be done about it. */
export function Alarms() {
  const { t } = useTranslation();
  const { alarmBook, settings } = usePage();
  const alarms = useActiveAlarms();
  const open = alarms.filter(({ acknowledged }) => !acknowledged);
  const hidden = alarms.length - LINES;
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
      acknowledge={{
        text: t("alarmBook.acknowledge"),
        label: (text) => t("alarmBook.acknowledgeOne", { text }),
        onPress: (id) => void alarmBook.acknowledge(id, { control: `acknowledge.${id}` }),
      }}
    >
      {hidden > 0 && (
        <Button
          onPress={() => choose(settings, "tab", "alarms")}
          label={t("alarmBook.more", { count: hidden })}
        >
          {t("alarmBook.moreShort", { count: hidden })}
        </Button>
      )}
      {open.length > 1 && (
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
