import { BellOff, Volume2 } from "lucide-react";
import { useTranslation } from "react-i18next";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { ALARM_LOG } from "./alarmLog";
import { useMutedFor_s } from "./useAlarms";
/** Two minutes of silence; while they last, how many seconds are left, and sound again at a press. */
export function MuteButton() {
  const { t } = useTranslation();
  const alarmLog = usePart(ALARM_LOG);
  const muted_s = useMutedFor_s();
  return muted_s === null ? (
    <Button onPress={alarmLog.mute} icon={<BellOff size={14} aria-hidden="true" />}>
      {t("alarmLog.mute")}
    </Button>
  ) : (
    <Button onPress={alarmLog.unmute} icon={<Volume2 size={14} aria-hidden="true" />}>
      {t("alarmLog.muted", { seconds: muted_s })}
    </Button>
  );
}
