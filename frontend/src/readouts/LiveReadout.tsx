import type { ParseKeys } from "i18next";
import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import type { NumberField, TopicName } from "../protocol/topics";
import { type Quantity, unitOfField } from "../store/chosenUnits";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { Readout, type ReadoutHandle, type ReadoutPress } from "../ui/Readout";
import type { Format } from "./formats";
import type { Notation } from "./notations";
import { useUnit } from "./useUnit";

/** Layout of a readout; a table can set it for all its rows. */
export interface ReadoutLayout {
  readonly chars?: number | undefined;
  readonly size?: "normal" | "large" | undefined;
}

/** One readout of a topic, as data. */
export interface ReadoutRow<Field extends string = string> extends ReadoutLayout {
  readonly field: Field;
  readonly label: ParseKeys;
  /** What the label means, where it is a word of the simulator's or of the wire. */
  readonly hint?: ParseKeys;
  /** Shown before the label where readouts of several groups are together: "Analog · Speed". */
  readonly group?: ParseKeys;
  /** A quantity is shown in the user's unit; its wire unit is the end of the field's name. */
  readonly as: Notation | Quantity;
  /** A more specific name of a quantity's wire unit: kias for knots. */
  readonly unit?: ParseKeys;
}

/** Readouts of one topic. A field that the topic does not have, or that is not a number, does not compile. */
export type ReadoutRows = {
  [T in TopicName]: { readonly topic: T; readonly rows: ReadonlyArray<ReadoutRow<NumberField<T>>> };
}[TopicName];

interface Props extends ReadoutRow {
  readonly topic: TopicName;
  readonly press?: ReadoutPress | undefined;
}

/** One number of a topic, with its state: painted ten times a second, without a render. */
export function LiveReadout({ as, ...rest }: Props) {
  return typeof as === "string" ? (
    <QuantityReadout {...rest} quantity={as} />
  ) : (
    <PaintedReadout {...rest} {...as} />
  );
}

function QuantityReadout({ quantity, unit, ...rest }: Omit<Props, "as"> & { quantity: Quantity }) {
  const { t } = useTranslation();
  const sent = unitOfField(rest.field);
  const { name, label, format } = useUnit(quantity, sent);
  return (
    <PaintedReadout {...rest} format={format} word={name === sent && unit !== undefined ? t(unit) : label} />
  );
}

interface ReadoutText extends Omit<Props, "as"> {
  readonly format: Format;
  /** The unit's name if it does not come from `unit`. */
  readonly word?: string;
}

function PaintedReadout(props: ReadoutText) {
  const { topic, field, format, label, hint, group, unit, word, chars, size, press } = props;
  const { t } = useTranslation();
  const readout = useRef<ReadoutHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      readout.current?.paint(format(telemetry.newestNumberOf(topic, field)), telemetry.state(topic, now_ms));
    },
    [topic, field, format],
  );
  usePaint("text", paint);
  const name = group === undefined ? t(label) : t("words.grouped", { group: t(group), name: t(label) });
  return (
    <Readout
      ref={readout}
      label={name}
      hint={hint === undefined ? undefined : t(hint)}
      unit={word ?? (unit === undefined ? undefined : t(unit))}
      chars={chars}
      size={size}
      press={press}
    />
  );
}
