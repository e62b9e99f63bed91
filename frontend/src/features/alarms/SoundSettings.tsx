import { Play } from "lucide-react";
import { useTranslation } from "react-i18next";
import { usePage, usePart, useSettings } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { RangeField } from "../../ui/RangeField";
import type { SounderState, SpeakerState } from "./alarmLog";
import { ALARM_LOG } from "./alarmLog";
import { type AlarmChannel, alarmSettings, chooseHeard, chooseVolume } from "./alarmSettings";
import { MuteButton } from "./MuteButton";
import type { AlarmLevel } from "./raisedAlarms";
import { useAlarmLogState } from "./useAlarms";

const LEVELS: readonly AlarmLevel[] = ["critical", "warning"];

/** Sound and speech of alarms. Stored in this browser: another one near the same pilot may stay silent. */
export function SoundSettings() {
  const { t } = useTranslation();
  const sounder = useAlarmLogState((state) => state.sounder);
  const language = useSettings((settings) => settings.language);
  const speaker = useAlarmLogState((state) => state.speaker[language]);
  return (
    <Panel title={t("alarmLog.heard")} actions={<MuteButton />}>
      <div className="alarms-heard">
        <Channel channel="sound" state={sounder} />
        <Channel channel="speech" state={speaker} />
        <Volume />
        <p className="alarms-range">{t("alarmLog.thisBrowser")}</p>
      </div>
    </Panel>
  );
}

interface ChannelProps {
  channel: AlarmChannel;
  state: SounderState | SpeakerState;
}

/** Settings of sound or speech: one switch per level, and a test. */
function Channel({ channel, state }: ChannelProps) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const alarmLog = usePart(ALARM_LOG);
  const chosen = alarmSettings(useSettings((all) => all));
  let why: string | undefined;
  if (state === "none") {
    why = t(`alarmLog.${channel}State.none`);
  } else if (state === "foreign") {
    why = t("alarmLog.speechState.foreign");
  }
  return (
    <fieldset className="alarms-channel">
      <legend>{t(`alarmLog.${channel}`)}</legend>
      {LEVELS.map((level) => (
        <div key={level} className="alarms-channel-level">
          <Checkbox
            label={t(`alarmLog.${level}`)}
            checked={chosen[channel][level]}
            onChange={(isOn) => chooseHeard(settings, channel, level, isOn)}
          />
          <Button
            onPress={() => alarmLog.test(channel, level)}
            icon={<Play size={14} aria-hidden="true" />}
            disabledReason={why}
            label={t(`alarmLog.test.${channel}.${level}`)}
          >
            {t("alarmLog.testShort")}
          </Button>
        </div>
      ))}
      {state === "waits" && <Notice level="info">{t(`alarmLog.${channel}State.waits`)}</Notice>}
      {why !== undefined && <Notice level="warning">{why}</Notice>}
    </fieldset>
  );
}

function Volume() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const { volume } = alarmSettings(useSettings((all) => all));
  const percent = Math.round(100 * volume);
  return (
    <RangeField
      label={t("alarmLog.volume")}
      value={percent}
      minimum={0}
      maximum={100}
      step={5}
      text={t("alarmLog.percent", { percent })}
      onChange={(next) => chooseVolume(settings, next / 100)}
    />
  );
}
