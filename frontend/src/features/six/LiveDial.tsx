import { useCallback, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { AirspeedIndicator } from "../../instruments/airspeed/AirspeedIndicator";
import type { AirspeedUnit } from "../../instruments/airspeed/geometry";
import { Altimeter } from "../../instruments/altitude/Altimeter";
import type { AltitudeUnit } from "../../instruments/altitude/geometry";
import type { DialHandle, PointerDialProps } from "../../instruments/dial/PointerDial";
import type { VerticalSpeedUnit } from "../../instruments/vvi/geometry";
import { VerticalSpeedIndicator } from "../../instruments/vvi/VerticalSpeedIndicator";
import type { ReadLive } from "../../readouts/LiveHeading";
import { type Unit, useUnit } from "../../readouts/useUnit";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";

/** Each dial is in the unit that the user chose; by default in the usual one of a cockpit, the first. */
const AIRSPEED: readonly AirspeedUnit[] = ["kt", "kmPerH", "mPerS"];
const ALTITUDE: readonly AltitudeUnit[] = ["ft", "m"];
const VERTICAL_SPEED: readonly VerticalSpeedUnit[] = ["ftPerMin", "mPerS"];

interface Props {
  /** In the unit in which the instrument is painted: knots, feet, feet per minute. */
  read: ReadLive;
  /** Accessible name. */
  label: string;
  /** Engraved on the face. */
  caption: string;
}

export function LiveAirspeed(props: Props) {
  const unit = useUnit("speed");
  return (
    <AirspeedIndicator {...useDial(props, unit)} face={AIRSPEED.find((face) => face === unit.name) ?? "kt"} />
  );
}

export function LiveAltimeter(props: Props) {
  const unit = useUnit("altitude");
  return <Altimeter {...useDial(props, unit)} face={ALTITUDE.find((face) => face === unit.name) ?? "ft"} />;
}

export function LiveVerticalSpeed(props: Props) {
  const unit = useUnit("verticalSpeed");
  return (
    <VerticalSpeedIndicator
      {...useDial(props, unit)}
      face={VERTICAL_SPEED.find((face) => face === unit.name) ?? "ftPerMin"}
    />
  );
}

/** The props of a pointer instrument, with its handle painted in each animation frame. */
function useDial({ read, label, caption }: Props, unit: Unit): PointerDialProps {
  const { t } = useTranslation();
  const ref = useRef<DialHandle>(null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => ref.current?.paint(read(telemetry, now_ms), now_ms),
    [read],
  );
  usePaint("movement", paint);
  return useMemo(() => {
    const format = (value: number): string => unit.format(value) ?? "";
    return {
      ref,
      label,
      caption,
      unit: unit.label,
      format,
      noDataText: t("words.noData"),
      offScaleText: t("six.offScale"),
      describe: (value) => t("six.sentence", { name: label, value: format(value), unit: unit.label }),
    };
  }, [t, unit, label, caption]);
}
