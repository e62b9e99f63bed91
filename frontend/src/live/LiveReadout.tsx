import { useCallback, useRef } from "react";
import type { NumberField, TopicName } from "../protocol/topics";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { Readout, type ReadoutHandle } from "../ui/Readout";
import type { Format } from "./formats";

interface Props<T extends TopicName> {
  topic: T;
  field: NumberField<T>;
  format: Format;
  label: string;
  unit?: string;
  chars?: number;
  size?: "normal" | "large";
}

/** One number of a topic, with its state: ten times a second, without a render. */
export function LiveReadout<T extends TopicName>({ topic, field, format, ...rest }: Props<T>) {
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      readout.current?.paint(format(telemetry.newestNumber(topic, field)), telemetry.state(topic, now_ms));
    },
    [topic, field, format],
  );
  usePaint("text", paint);
  return <Readout ref={readout} {...rest} />;
}
