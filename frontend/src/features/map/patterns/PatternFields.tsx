import { useTranslation } from "react-i18next";
import { PLAN_LIMITS } from "../../../protocol/missions";
import { type Unit, useUnit } from "../../../readouts/useUnit";
import { NumberField } from "../../../ui/NumberField";

interface LengthProps {
  label: string;
  value_m: number;
  minimum_m: number;
  maximum_m: number;
  onCommit: (value_m: number) => void;
}

/** A length along the ground, in the user's unit. */
export function LengthField({ label, value_m, minimum_m, maximum_m, onCommit }: LengthProps) {
  const distance = useUnit("distance");
  // Kilometres and miles need decimals, metres and feet none.
  const digits = distance.name === "m" || distance.name === "ft" ? 0 : 2;
  return (
    <NumberField
      label={label}
      value={distance.convert(value_m)}
      minimum={distance.convert(minimum_m)}
      maximum={distance.convert(maximum_m)}
      step={digits === 0 ? 50 : 0.05}
      format={(value) => value.toFixed(digits)}
      unit={distance.label}
      onCommit={(shown) => onCommit(distance.revert(shown))}
    />
  );
}

interface Props {
  label: string;
  value: number;
  minimum: number;
  maximum: number;
  onCommit: (value: number) => void;
}

export function HeightField({ label, value, minimum, maximum, onCommit }: Props) {
  return <UnitField {...{ label, value, minimum, maximum, onCommit }} unit={useUnit("altitude")} step={50} />;
}

/** Indicated airspeed, within what the board takes. */
export function SpeedField({ value, onCommit }: Pick<Props, "value" | "onCommit">) {
  const { t } = useTranslation();
  const { minimum, maximum } = PLAN_LIMITS.fields.speed_kt;
  return (
    <UnitField
      label={t("plans.speed")}
      {...{ value, minimum, maximum, onCommit }}
      unit={useUnit("speed")}
      step={1}
    />
  );
}

export function AngleField({ label, value, onCommit }: Pick<Props, "label" | "value" | "onCommit">) {
  const { t } = useTranslation();
  return (
    <NumberField
      label={label}
      value={value}
      minimum={0}
      maximum={360}
      step={5}
      format={(shown) => shown.toFixed(0)}
      unit={t("unit.deg")}
      onCommit={onCommit}
    />
  );
}

function UnitField({
  label,
  value,
  minimum,
  maximum,
  unit,
  step,
  onCommit,
}: Props & { unit: Unit; step: number }) {
  return (
    <NumberField
      label={label}
      value={unit.convert(value)}
      minimum={unit.convert(minimum)}
      maximum={unit.convert(maximum)}
      step={step}
      format={(shown) => shown.toFixed(unit.digits)}
      unit={unit.label}
      onCommit={(shown) => onCommit(unit.revert(shown))}
    />
  );
}
