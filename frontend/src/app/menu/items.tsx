import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import type { CommandName } from "../../protocol/messages.gen";
import type { CommandValue } from "../../requests/actions";
import { ACTIONS } from "../../requests/actions";
import { useBoardBlocked } from "../../requests/useBlocked";
import type { CommandState } from "../../store/commands";
import { useCommandEntry, usePage, usePart, useTelemetry } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { MenuAction, MenuSwitch } from "../../ui/MenuBar";

interface Outcome {
  readonly state: CommandState;
  readonly stateText: string | undefined;
}

const IDLE: Outcome = { state: "idle", stateText: undefined };

/** The outcome of a control's newest request, if that request was this entry's: two entries can share a control. */
export function useOutcome(control: string, asked?: string): Outcome {
  const sentence = useSentence();
  const entry = useCommandEntry(control);
  if (entry === null || (asked !== undefined && entry.asked !== asked)) {
    return IDLE;
  }
  return { state: entry.state, stateText: entry.message === null ? undefined : sentence(entry.message) };
}

interface CommandProps {
  command: CommandName;
  label?: string;
  value?: CommandValue;
  /** Entries of one switch share a control; each names the position that it requests. */
  control?: string;
  asked?: string;
  isCurrent?: boolean;
  disabledReason?: string | undefined;
  danger?: boolean;
  /** Sent whatever the state: the gateway answers where it cannot be done. */
  always?: boolean;
  /** Ask the user first; `send` goes on. */
  confirm?: (send: () => void) => void;
}

/** A menu entry that sends one command and shows its outcome. */
export function CommandItem(props: CommandProps): ReactNode {
  const {
    command,
    label,
    value,
    control = command,
    asked,
    isCurrent,
    disabledReason,
    danger,
    always = false,
    confirm,
  } = props;
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const blocked = useBoardBlocked();
  const outcome = useOutcome(control, asked);
  const send = (): void =>
    void actions.command(command, asked === undefined ? { control } : { control, asked }, value);
  return (
    <MenuAction
      label={label ?? t(`command.${command}`)}
      onChoose={() => (confirm === undefined ? send() : confirm(send))}
      isCurrent={isCurrent}
      danger={danger}
      disabledReason={always ? undefined : (blocked ?? disabledReason)}
      {...outcome}
    />
  );
}

interface SwitchProps {
  label: string;
  control: string;
  on: CommandName;
  off: CommandName;
  read: (telemetry: TelemetryStore) => boolean | null;
}

/**
 * A switch in the position that the heartbeat's flag reports; without a live heartbeat in none. A heartbeat that is
 * merely late is no reason to refuse a press: it asks for the other position than the one that was seen last.
 */
export function FlagSwitch({ label, control, on, off, read }: SwitchProps): ReactNode {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const blocked = useBoardBlocked();
  const outcome = useOutcome(control);
  const { telemetry } = usePage();
  const seen = useTelemetry(read);
  const isLive = useTelemetry((known, now_ms) => known.state("heartbeat", now_ms) === "live");
  const late = isLive ? undefined : t("menu.noHeartbeat");
  return (
    <MenuSwitch
      label={label}
      checked={isLive && seen === true}
      onChange={() => {
        const isOn = read(telemetry) === true;
        void actions.command(isOn ? off : on, { control, asked: isOn ? "off" : "on" });
      }}
      disabledReason={blocked ?? (seen === null ? t("menu.noHeartbeat") : undefined)}
      state={outcome.state}
      stateText={outcome.stateText ?? (outcome.state === "idle" ? late : undefined)}
    />
  );
}
