import type { TopicName } from "../protocol/topics";
import { useTelemetry } from "../store/hooks";
import type { TelemetryStore } from "../store/telemetry";
import { StatusFlag } from "../ui/StatusFlag";

/** A flag of a topic; null if unknown. */
export type ReadFlag = (telemetry: TelemetryStore) => boolean | null;

interface Props {
  topic: TopicName;
  read: ReadFlag;
  label: string;
  texts?: { on: string; off: string };
}

/** A lamp and a word for one flag of a topic; marked when the topic is not live. */
export function LiveFlag({ topic, read, label, texts }: Props) {
  const isOn = useTelemetry(read);
  const state = useTelemetry((telemetry, now_ms) => telemetry.state(topic, now_ms));
  return (
    <StatusFlag
      label={label}
      value={state === "none" ? null : isOn}
      stale={state === "stale"}
      texts={texts}
    />
  );
}
