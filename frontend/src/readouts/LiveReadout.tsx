import { useCallback, useRef } from "react";
import type { NumberField, TopicName } from "../protocol/topics";
import { type Quantity, unitOfField } from "../store/chosenUnits";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { Readout, type ReadoutHandle } from "../ui/Readout";
import type { Format } from "./formats";
import { useUnit } from "./useUnit";

interface Place<T extends TopicName> {
  field: NumberField<T>;
  label: string;
  chars?: number;
  size?: "normal" | "large";
}

interface Plain {
  format: Format;
  unit?: string;
  quantity?: never;
}

interface Measured {
  /** The person chooses its unit; the unit of the wire stands at the end of the field's name. */
  quantity: Quantity;
  /** A finer word for the wire's own unit: kias for knots. */
  unit?: string;
  format?: never;
}

/** What a readout of a field is told, beside its topic. */
export type FieldProps<T extends TopicName> = Place<T> & (Plain | Measured);

interface Topic<T extends TopicName> {
  topic: T;
}

/** One number of a topic, with its state: ten times a second, without a render. */
export function LiveReadout<T extends TopicName>(props: Topic<T> & FieldProps<T>) {
  return props.quantity === undefined ? <PlainReadout {...props} /> : <MeasuredReadout {...props} />;
}

function MeasuredReadout<T extends TopicName>({ quantity, unit, ...rest }: Topic<T> & Place<T> & Measured) {
  const sent = unitOfField(rest.field);
  const { name, label, format } = useUnit(quantity, sent);
  const word = name === sent && unit !== undefined ? unit : label;
  return <PlainReadout {...rest} format={format} unit={word} />;
}

function PlainReadout<T extends TopicName>({ topic, field, format, ...rest }: Topic<T> & Place<T> & Plain) {
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
