import { Cpu, Gamepad2, Hand, RadioTower } from "lucide-react";
import { useTranslation } from "react-i18next";
import { readAutopilot, readAutotrim } from "../../features/controls/axes";
import { useSource } from "../../features/controls/sourceReturn";
import type { CommandName } from "../../protocol/messages.gen";
import { ACTIONS } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked, useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, usePart, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { useChoosePath } from "./useChoosePath";

/** Autopilot and autotrim. */
export function AutomaticControls() {
  return (
    <>
      <OnOffSwitch name="autopilot" on="autopilot_on" off="autopilot_off" read={readAutopilot} />
      <OnOffSwitch name="autotrim" on="autotrim_on" off="autotrim_off" read={readAutotrim} />
    </>
  );
}

/** Who commands the aircraft: the path of the control signal and its source. */
export function SignalControls() {
  return (
    <>
      <PathSwitch />
      <SourceSwitch />
    </>
  );
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

function PathSwitch() {
  const { t } = useTranslation();
  const choosePath = useChoosePath();
  const { state, stateText, wanted } = useAsked("path");
  const blocked = useGatewayBlocked();
  const value = useConnection(({ status, phase }) => (phase === "open" ? (status?.hil.path ?? null) : null));
  return (
    <SegmentedSwitch
      label={t("toolbar.path")}
      options={[
        {
          value: "manual",
          label: t("path.manual"),
          icon: <Hand aria-hidden="true" size={14} />,
          always: true,
        },
        { value: "assisted", label: t("path.assisted"), icon: <Cpu aria-hidden="true" size={14} /> },
      ]}
      value={value}
      wanted={wanted === "manual" || wanted === "assisted" ? wanted : null}
      onChange={choosePath}
      state={state}
      stateText={stateText}
      disabledReason={blocked}
    />
  );
}

function SourceSwitch() {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const { state, stateText, wanted } = useAsked("source");
  const blocked = useBoardBlocked();
  return (
    <SegmentedSwitch
      label={t("toolbar.source")}
      options={[
        { value: "joystick", label: t("source.joystick"), icon: <Gamepad2 aria-hidden="true" size={14} /> },
        { value: "rc", label: t("source.rc"), icon: <RadioTower aria-hidden="true" size={14} /> },
      ]}
      value={useSource()}
      wanted={wanted === "joystick" || wanted === "rc" ? wanted : null}
      onChange={(source) => void actions.setHil({ source }, { control: "source", asked: source })}
      state={state}
      stateText={stateText}
      disabledReason={blocked}
    />
  );
}
