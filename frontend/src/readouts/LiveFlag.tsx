import type { TopicName } from "../protocol/topics";
import { useTelemetry } from "../store/hooks";
import type { TelemetryStore } from "../store/telemetry";
import { StatusFlag } from "../ui/StatusFlag";

/** A flag out of a topic: null is not known. */
export type ReadFlag = (telemetry: TelemetryStore) => boolean | null;

interface Props {
  topic: TopicName;
  read: ReadFlag;
  label: string;
  texts?: { on: string; off: string };
}

/** A lamp with its word for one flag of a topic; when the topic is not live it says so. */
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
