import { useTranslation } from "react-i18next";
import { useEmulation } from "../../features/emulation/EmulationBanner";
import { EMULATION } from "../../features/emulation/emulationRequests";
import type { CommandName } from "../../protocol/messages.gen";
import type { FlagField } from "../../protocol/topics";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart, useTelemetry } from "../../store/hooks";
import { Menu, MenuRule, MenuSwitch } from "../../ui/MenuBar";
import { CommandItem, FlagSwitch, useOutcome } from "./items";

interface Stream {
  readonly name: "analog" | "inertial" | "ahrs" | "statistics" | "gps" | "servosIn" | "flyByWire";
  readonly flag: FlagField<"heartbeat">;
  readonly on: CommandName;
  readonly off: CommandName;
}

/** The streams whose state the heartbeat tells, in the order in which users know them. */
const STREAMS: readonly Stream[] = [
  { name: "analog", flag: "analog", on: "analog_on", off: "analog_off" },
  { name: "inertial", flag: "inertial", on: "inertial_on", off: "inertial_off" },
  { name: "ahrs", flag: "ahrs", on: "ahrs_on", off: "ahrs_off" },
  { name: "statistics", flag: "statistics", on: "statistics_on", off: "statistics_off" },
  { name: "gps", flag: "gps", on: "gps_on", off: "gps_off" },
  { name: "servosIn", flag: "servos", on: "servos_in_on", off: "servos_in_off" },
  { name: "flyByWire", flag: "fly_by_wire", on: "fly_by_wire_on", off: "fly_by_wire_off" },
];

export function ParametersMenu() {
  const { t } = useTranslation();
  return (
    <Menu label={t("menu.parameters")}>
      <CommandItem command="start" />
      <CommandItem command="stop" />
      <MenuRule />
      {STREAMS.map(({ name, flag, on, off }) => (
        <FlagSwitch
          key={name}
          label={t(`menuStream.${name}`)}
          control={`stream.${name}`}
          on={on}
          off={off}
          read={(telemetry) => telemetry.newestFlag("heartbeat", flag)}
        />
      ))}
      <MenuRule />
      <PlanItems topic="fms_plan" on="fms_plan_on" off="fms_plan_off" />
      <PlanItems topic="fms_hil_plan" on="fms_hil_plan_on" off="fms_hil_plan_off" />
      <MenuRule />
      <EmulationSwitch />
    </Menu>
  );
}

interface PlanProps {
  topic: "fms_plan" | "fms_hil_plan";
  on: CommandName;
  off: CommandName;
}

/** The heartbeat has no flag for the two plans: whether they are sent is known only by whether they arrive. */
function PlanItems({ topic, on, off }: PlanProps) {
  const isOn = useTelemetry((telemetry, now_ms) =>
    telemetry.state("heartbeat", now_ms) === "live" ? telemetry.state(topic, now_ms) === "live" : null,
  );
  return (
    <>
      <CommandItem command={on} control={`stream.${topic}`} asked="on" isCurrent={isOn === true} />
      <CommandItem command={off} control={`stream.${topic}`} asked="off" isCurrent={isOn === false} />
    </>
  );
}

function EmulationSwitch() {
  const { t } = useTranslation();
  const emulation = usePart(EMULATION);
  const blocked = useGatewayBlocked();
  const { isOn, before_url } = useEmulation();
  const asker = { control: "emulation" };
  return (
    <MenuSwitch
      label={t("menu.emulation")}
      checked={isOn}
      onChange={(checked) => void (checked ? emulation.start(asker) : emulation.end(before_url, asker))}
      disabledReason={blocked}
      {...useOutcome("emulation")}
    />
  );
}
