import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { type TapeScale, tapeOf } from "../../instruments/tape/geometry";
import { Tape, type TapeHandle } from "../../instruments/tape/Tape";
import type { ReadLive } from "../../readouts/LiveHeading";
import { useUnit } from "../../readouts/useUnit";
import { type Quantity, usualUnit } from "../../store/chosenUnits";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Tooltip } from "../../ui/Tooltip";

interface Props {
  quantity: Quantity & ("speed" | "altitude");
  scales: readonly [TapeScale, ...TapeScale[]];
  attribute: `data-${string}`;
  side: "left" | "right";
  /** Accessible name. */
  label: string;
  /** Value and target in the usual unit, knots or feet; null if not live. */
  read: ReadLive;
  target: ReadLive;
  /** What a press on it does. */
  press: { readonly label: string; readonly onPress: () => void };
}

/** A tape over live values, in the unit that the user chose; by default in that of a cockpit. */
export function LiveTape({ quantity, scales, attribute, side, label, read, target, press }: Props) {
  const { t } = useTranslation();
  const unit = useUnit(quantity);
  const tape = useRef<TapeHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) =>
      tape.current?.paint(read(telemetry, now_ms), target(telemetry, now_ms), now_ms),
    [read, target],
  );
  usePaint("movement", paint);
  const format = useCallback((value: number) => unit.format(value) ?? "", [unit]);
  const describe = useCallback(
    (value: number) => t("six.sentence", { name: label, value: format(value), unit: unit.label }),
    [t, label, format, unit],
  );
  return (
    <div className="fly-tape" data-side={side}>
      <Tape
        ref={tape}
        scale={tapeOf(scales, unit.name)}
        usual={usualUnit(quantity)}
        attribute={attribute}
        side={side}
        label={label}
        unit={unit.label}
        noDataText={t("words.noData")}
        format={format}
        describe={describe}
      />
      <Tooltip text={press.label}>
        <button type="button" className="fly-press" aria-label={press.label} onClick={press.onPress} />
      </Tooltip>
    </div>
  );
}
