import { useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { ServoBar, type ServoBarHandle } from "../instruments/servo/ServoBar";
import type { NumberField, TopicName } from "../protocol/topics";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { hundredths } from "./formats";

interface Props<T extends TopicName> {
  topic: T;
  field: NumberField<T>;
  label: string;
  kind?: "surface" | "throttle";
  orientation?: "vertical" | "horizontal";
}

const position = (value: number): string => hundredths(value) ?? "";

/** One control's position as a bar that is painted in each animation frame. */
export function LiveServoBar<T extends TopicName>({ topic, field, ...rest }: Props<T>) {
  const { t } = useTranslation();
  const bar = useRef<ServoBarHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) =>
      bar.current?.paint(telemetry.liveNumber(topic, field, now_ms), now_ms),
    [topic, field],
  );
  usePaint("movement", paint);
  return <ServoBar ref={bar} noDataText={t("words.dash")} format={position} {...rest} />;
}

type Control = "elevator" | "aileron" | "rudder" | "throttle";

/** The positions of the aircraft's controls, one bar under the other. */
export function LiveControlBars({
  topic,
  controls,
}: {
  topic: "fly_by_wire" | "hil_surfaces";
  controls: readonly Control[];
}) {
  const { t } = useTranslation();
  return controls.map((control) => (
    <LiveServoBar
      key={control}
      topic={topic}
      field={control}
      label={t(`control.${control}`)}
      kind={control === "throttle" ? "throttle" : "surface"}
      orientation="horizontal"
    />
  ));
}
