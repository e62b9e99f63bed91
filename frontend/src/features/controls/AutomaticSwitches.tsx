import { useTranslation } from "react-i18next";
import type { CommandName } from "../../protocol/messages.gen";
import { ACTIONS } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePart, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { readAutopilot, readAutotrim } from "./axes";
import { useSource } from "./sourceReturn";

export function AutopilotSwitch() {
  return <OnOffSwitch name="autopilot" on="autopilot_on" off="autopilot_off" read={readAutopilot} />;
}

export function AutotrimSwitch() {
  return <OnOffSwitch name="autotrim" on="autotrim_on" off="autotrim_off" read={readAutotrim} />;
}

interface OnOffProps {
  name: "autopilot" | "autotrim";
  on: CommandName;
  off: CommandName;
  read: (telemetry: TelemetryStore) => boolean | null;
}

function OnOffSwitch({ name, on, off, read }: OnOffProps) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const { state, stateText, wanted } = useAsked(name);
  const blocked = useBoardBlocked();
  const source = useSource();
  const value = useTelemetry((telemetry, now_ms) => {
    const isOn = telemetry.state("heartbeat", now_ms) === "live" ? read(telemetry) : null;
    return isOn === null ? null : isOn ? "on" : "off";
  });
  // With RC as source the transmitter's own switch decides, and the board refuses these commands.
  const reason = blocked ?? (source === "rc" ? t("blocked.transmitter") : undefined);
  return (
    <SegmentedSwitch
      label={t(`flag.${name}`)}
      options={[
        { value: "on", label: t("words.on") },
        { value: "off", label: t("words.off"), always: name === "autopilot" },
      ]}
      value={value}
      wanted={wanted === "on" || wanted === "off" ? wanted : null}
      onChange={(asked) => void actions.command(asked === "on" ? on : off, { control: name, asked })}
      state={state}
      stateText={stateText}
      disabledReason={reason}
    />
  );
}
