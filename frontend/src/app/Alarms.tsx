import { useTranslation } from "react-i18next";
import { useSentence } from "../i18n/useSentence";
import { useConnection } from "../store/hooks";
import { wordsOf } from "../store/messages";
import { type AlarmItem, AlarmStrip } from "../ui/AlarmStrip";

/** What is wrong now, on every tab. Without the gateway nothing that it said counts: that alone is shown. */
export function Alarms() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const phase = useConnection((connection) => connection.phase);
  const alarms = useConnection(({ status }) => status?.alarms);
  const missing = useConnection(({ status }) => status?.simulator.missing_rows.join(", ") ?? "");
  const isSimulatorHeard = useConnection(({ status }) => status?.simulator.state === "open");
  // The gateway has one alarm for the loop; where it is open can be seen from the state of its two ends.
  const hilReason = !isSimulatorHeard ? "hil_lost_simulator" : missing !== "" ? "hil_lost_rows" : "hil_lost";
  const known = useConnection(({ status }) => status !== null);
  let items: readonly AlarmItem[] = [];
  if (phase === "open") {
    items = (alarms ?? []).map(({ id, level, text, params }) => ({
      id,
      level,
      text: sentence({
        level: "warning",
        key: `alarm.${id === "hil_lost" ? hilReason : id}`,
        params: { ...wordsOf(params), rows: missing },
        fallback: text,
      }),
    }));
  } else if (known || phase === "waiting") {
    items = [
      {
        id: "gateway_lost",
        level: "critical",
        text: t(phase === "silent" ? "alarm.gateway_silent" : "alarm.gateway_lost"),
      },
    ];
  }
  return <AlarmStrip label={t("alarms.label")} alarms={items} />;
}
