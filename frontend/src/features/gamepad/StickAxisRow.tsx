import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { ServoBar, type ServoBarHandle } from "../../instruments/servo/ServoBar";
import { hundredths } from "../../readouts/formats";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { Select } from "../../ui/Select";
import { GAMEPADS, useGamepads } from "./gamepadList";
import type { PadInput, StickAxis } from "./stickMapping";

const DEAD_ZONES_PERCENT = [0, 2, 5, 10, 15, 20, 30] as const;

const position = (value: number): string => hundredths(value) ?? "";

/** One axis: where it stands now, what moves it, its direction and its dead zone. */
export function StickAxisRow({ axis }: { axis: StickAxis }) {
  const { t } = useTranslation();
  const gamepads = usePart(GAMEPADS);
  const mapping = useGamepads((state) => state.mapping?.[axis] ?? null);
  const isAssigning = useGamepads(({ assigning }) => assigning === axis);
  const isAwaited = useGamepads(({ awaited }) => awaited.includes(axis));
  if (mapping === null) {
    return null;
  }
  const name = t(`control.${axis}`);
  const { input, isInverted, deadZone, springs } = mapping;
  const percent = Math.round(deadZone * 100);
  return (
    <fieldset className="setup-axis">
      <legend className="visually-hidden">{name}</legend>
      <Bar axis={axis} label={name} />
      <span className="setup-axis-input" role="status" data-assigning={isAssigning}>
        {isAssigning ? t(`gamepad.move.${axis}`) : <InputName input={input} />}
        {isAwaited && !isAssigning && ` · ${t("gamepad.notMoved")}`}
      </span>
      <Button
        onPress={() => gamepads.assign(isAssigning ? null : axis)}
        pressed={isAssigning}
        label={t(isAssigning ? "gamepad.cancelAxis" : "gamepad.assignAxis", { axis: name })}
      >
        {isAssigning ? t("dialog.cancel") : t("gamepad.assign")}
      </Button>
      <Checkbox
        label={t("gamepad.invert", { axis: name })}
        checked={isInverted}
        onChange={(checked) => gamepads.change(axis, { isInverted: checked })}
      />
      <Select
        label={t("gamepad.deadZone", { axis: name })}
        options={DEAD_ZONES_PERCENT.map((value) => ({
          value: `${value}`,
          label: t("gamepad.percent", { percent: value }),
        }))}
        value={`${percent}`}
        placeholder={t("gamepad.percent", { percent })}
        onChange={(value) => gamepads.change(axis, { deadZone: Number(value) / 100 })}
      />
      {axis === "throttle" && input?.startsWith("a") === true && (
        <Select
          label={t("gamepad.way")}
          options={[
            { value: "lever", label: t("gamepad.lever") },
            { value: "springs", label: t("gamepad.springs") },
          ]}
          value={springs ? "springs" : "lever"}
          placeholder={t("gamepad.lever")}
          onChange={(value) => gamepads.change(axis, { springs: value === "springs" })}
        />
      )}
    </fieldset>
  );
}

function InputName({ input }: { input: PadInput | null }) {
  const { t } = useTranslation();
  if (input === null) {
    return t("gamepad.unassigned");
  }
  const number = Number(input.slice(1)) + 1;
  return input.startsWith("a") ? t("gamepad.axis", { number }) : t("gamepad.button", { number });
}

function Bar({ axis, label }: { axis: StickAxis; label: string }) {
  const { t } = useTranslation();
  const gamepads = usePart(GAMEPADS);
  const bar = useRef<ServoBarHandle>(null);
  useEffect(() => gamepads.watch((positions) => bar.current?.paint(positions[axis])), [gamepads, axis]);
  return (
    <ServoBar
      ref={bar}
      label={label}
      noDataText={t("words.dash")}
      format={position}
      kind={axis === "throttle" ? "throttle" : "surface"}
      orientation="horizontal"
    />
  );
}
