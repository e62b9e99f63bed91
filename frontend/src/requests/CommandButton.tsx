import type { ReactNode } from "react";
import type { CommandName } from "../protocol/messages.gen";
import { usePart } from "../store/hooks";
import { Button } from "../ui/Button";
import { ACTIONS } from "./actions";
import { useAsked } from "./useAsked";
import { useBoardBlocked } from "./useBlocked";

interface Props {
  command: CommandName;
  children?: ReactNode;
  icon?: ReactNode;
  /** Accessible name, for a button with only an icon. */
  label?: string;
}

/** A button that sends one command and shows its outcome. */
export function CommandButton({ command, children, icon, label }: Props) {
  const actions = usePart(ACTIONS);
  const { state, stateText } = useAsked(command);
  const blocked = useBoardBlocked();
  return (
    <Button
      onPress={() => void actions.command(command, { control: command })}
      state={state}
      stateText={stateText}
      disabledReason={blocked}
      icon={icon}
      label={label}
    >
      {children}
    </Button>
  );
}
