import { useTranslation } from "react-i18next";
import type { FlagField } from "../../protocol/topics";
import { OtherAutopilot } from "../../readouts/AutomaticFlags";
import { LiveFlag } from "../../readouts/LiveFlag";
import { LiveBadge } from "../../readouts/StreamPanel";
import { CommandButton } from "../../requests/CommandButton";
import { Panel } from "../../ui/Panel";

const FLAGS = [
  "analog",
  "inertial",
  "ahrs",
  "statistics",
  "gps",
  "servos",
  "fly_by_wire",
  "auto_switch",
  "autotrim",
  "autopilot",
] as const satisfies readonly FlagField<"heartbeat">[];

/** What the heartbeat says of the board: which streams it sends, and who flies. */
export function StateReport() {
  const { t } = useTranslation();
  return (
    <Panel
      title={t("flight.state")}
      hint={t("termHint.state")}
      className="flight-state"
      badge={<LiveBadge topic="heartbeat" />}
      actions={<CommandButton command="read_all">{t("flight.readAll")}</CommandButton>}
    >
      <ul className="flight-flags">
        {FLAGS.map((flag) => (
          <li key={flag}>
            <LiveFlag
              topic="heartbeat"
              read={(telemetry) => telemetry.newestFlag("heartbeat", flag)}
              label={t(`flag.${flag}`)}
            />
          </li>
        ))}
      </ul>
      <OtherAutopilot />
    </Panel>
  );
}
