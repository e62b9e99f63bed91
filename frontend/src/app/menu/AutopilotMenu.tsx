import { useTranslation } from "react-i18next";
import { readAutopilot, readAutotrim } from "../../features/controls/axes";
import { useSource } from "../../features/controls/sourceReturn";
import type { CommandName } from "../../protocol/messages.gen";
import type { NumberField } from "../../protocol/topics";
import { ACTIONS } from "../../requests/actions";
import { useBoardBlocked } from "../../requests/useBlocked";
import { useConnection, usePart, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { Menu, MenuChoice, MenuRule } from "../../ui/MenuBar";
import { useDialogs } from "../views/useDialogs";
import { CommandItem, useOutcome } from "./items";

export function AutopilotMenu() {
  const { t } = useTranslation();
  return (
    <Menu label={t("menu.autopilot")}>
      <OnOff
        name="autopilot"
        labels={[t("words.on"), t("words.off")]}
        on="autopilot_on"
        off="autopilot_off"
        read={readAutopilot}
      />
      <OnOff
        name="autotrim"
        labels={[t("command.autotrim_on"), t("command.autotrim_off")]}
        on="autotrim_on"
        off="autotrim_off"
        read={readAutotrim}
      />
      <MenuRule />
      <SourceChoice
        label={t("menu.speedSource")}
        command="select_airspeed_source"
        field="airspeed_source"
        words={[t("menu.gps"), t("menu.pitot")]}
      />
      <SourceChoice
        label={t("menu.altitudeSource")}
        command="select_altitude_source"
        field="altitude_source"
        words={[t("menu.gps"), t("menu.baro")]}
      />
      <MenuRule />
      <Reset />
    </Menu>
  );
}

interface OnOffProps {
  name: "autopilot" | "autotrim";
  labels: readonly [string, string];
  on: CommandName;
  off: CommandName;
  read: (telemetry: TelemetryStore) => boolean | null;
}

function OnOff({ name, labels, on, off, read }: OnOffProps) {
  const { t } = useTranslation();
  const source = useSource();
  const isOn = useTelemetry((telemetry, now_ms) =>
    telemetry.state("heartbeat", now_ms) === "live" ? read(telemetry) : null,
  );
  // With RC as source the transmitter's own switch decides, and the board refuses these commands.
  const disabledReason = source === "rc" ? t("blocked.transmitter") : undefined;
  return (
    <>
      <CommandItem
        command={on}
        label={labels[0]}
        control={name}
        asked="on"
        isCurrent={isOn === true}
        disabledReason={disabledReason}
      />
      <CommandItem
        command={off}
        label={labels[1]}
        control={name}
        asked="off"
        isCurrent={isOn === false}
        disabledReason={disabledReason}
        always={name === "autopilot"}
      />
    </>
  );
}

interface SourceProps {
  label: string;
  command: "select_airspeed_source" | "select_altitude_source";
  field: NumberField<"board_status">;
  /** Words for the sources, by their number on the wire. */
  words: readonly [string, string];
}

function SourceChoice({ label, command, field, words }: SourceProps) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const blocked = useBoardBlocked();
  const hasSources = useConnection(({ status }) => status?.board.features.sources === true);
  const value = useTelemetry((telemetry, now_ms) => telemetry.liveNumber("board_status", field, now_ms));
  return (
    <MenuChoice
      label={label}
      options={words.map((word, source) => ({ value: String(source), label: word }))}
      value={value === null ? null : String(value)}
      onChange={(source) =>
        void actions.command(command, { control: command, asked: source }, Number(source))
      }
      disabledReason={blocked ?? (hasSources ? undefined : t("menu.legacy"))}
      {...useOutcome(command)}
    />
  );
}

function Reset() {
  const { t } = useTranslation();
  const { ask } = useDialogs();
  return (
    <CommandItem
      command="reset"
      label={t("menu.reset")}
      danger
      confirm={(send) =>
        ask({
          title: t("menu.resetTitle"),
          text: t("menu.resetText"),
          confirm: t("menu.resetConfirm"),
          danger: true,
          onConfirm: send,
        })
      }
    />
  );
}
