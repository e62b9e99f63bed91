import { useTranslation } from "react-i18next";
import { COMMANDS, type CommandName } from "../../protocol/messages.gen";
import { ACTIONS } from "../../requests/actions";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { useConnection, usePart } from "../../store/hooks";
import { NumberField } from "../../ui/NumberField";
import "./refresh.css";

const TASKS = {
  parameters: "set_parameter_task_rate",
  fms: "set_fms_task_rate",
  servos: "set_servos_task_rate",
} as const satisfies Readonly<Record<string, CommandName>>;
type Task = keyof typeof TASKS;

const STEP_MS = 10;

/** "Refresco": how often the board's three tasks send their streams. */
export function Refresh() {
  return (
    <div className="refresh">
      <Period task="parameters" />
      <Period task="fms" />
      <Period task="servos" />
    </div>
  );
}

/**
 * One task's period. The board does not report it: shown is what this station requested, or else the board's default;
 * a text says which.
 */
function Period({ task }: { task: Task }) {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const command = TASKS[task];
  const { state, stateText } = useAsked(command);
  const blocked = useBoardBlocked();
  const period_ms = useConnection(({ status, phase }) =>
    phase === "open" && status?.board.state === "open" ? status.board.periods_ms[task].ms : null,
  );
  const isChosen = useConnection(({ status }) => status?.board.periods_ms[task].chosen === true);
  const range = COMMANDS[command].arguments[0];
  const minimum = range?.minimum ?? 0;
  const maximum = range?.maximum ?? 0;
  return (
    <div className="refresh-task">
      <NumberField
        label={t(`refresh.${task}`)}
        value={period_ms}
        onCommit={(value) => void actions.command(command, { control: command }, Math.round(value))}
        minimum={minimum}
        maximum={maximum}
        step={STEP_MS}
        unit={t("unit.ms")}
        state={state}
        stateText={stateText}
        disabledReason={blocked}
      />
      <p className="refresh-note">
        {period_ms === null ? t("refresh.unknown") : t(isChosen ? "refresh.chosen" : "refresh.byDefault")}
      </p>
      <p className="refresh-note">
        {t("refresh.range", { minimum, maximum, usual: range?.default ?? t("words.dash") })}
      </p>
      <p className="refresh-note">{t(`refresh.${task}Streams`)}</p>
    </div>
  );
}
