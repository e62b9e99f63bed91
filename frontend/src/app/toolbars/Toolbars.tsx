import { Cpu, Gamepad2, Hand, RadioTower } from "lucide-react";
import { useTranslation } from "react-i18next";
import { AutopilotSwitch, AutotrimSwitch } from "../../features/controls/AutomaticSwitches";
import { useSource } from "../../features/controls/sourceReturn";
import { ACTIONS } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked, useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, usePart } from "../../store/hooks";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { useChoosePath } from "./useChoosePath";

/** Autopilot and autotrim. */
export function AutomaticControls() {
  return (
    <>
      <AutopilotSwitch />
      <AutotrimSwitch />
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
