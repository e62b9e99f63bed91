import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { ALTITUDE_TAPES, SPEED_TAPES } from "../../instruments/tape/geometry";
import type { Aircraft } from "../../lib/aircraft";
import { useFlownAircraft } from "../../readouts/flownAircraft";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { LiveHeading, type ReadLive } from "../../readouts/LiveHeading";
import { isGpsSpeed, SIX } from "../../readouts/sources";
import { useTelemetry } from "../../store/hooks";
import { Figures } from "./Figures";
import { LiveTape } from "./LiveTape";
import "./fly.css";

/** What the plan asks for, feet and knots. */
const TARGET: Readonly<Record<Aircraft, { readonly altitude_ft: ReadLive; readonly speed_kt: ReadLive }>> = {
  flight: {
    altitude_ft: (telemetry, now_ms) => telemetry.liveNumber("fms_plan", "altitude_ft", now_ms),
    speed_kt: (telemetry, now_ms) => telemetry.liveNumber("fms_plan", "speed_kt", now_ms),
  },
  hil: {
    altitude_ft: (telemetry, now_ms) => telemetry.liveNumber("fms_hil_plan", "altitude_ft", now_ms),
    speed_kt: (telemetry, now_ms) => telemetry.liveNumber("fms_hil_plan", "speed_kt", now_ms),
  },
};

interface Props {
  /** What stands over the horizon. */
  readonly modes: ReactNode;
  readonly onPlot: (signal: string) => void;
  /** Change what the plan asks for at the waypoint that is flown to. */
  readonly onTarget: (field: "altitude_ft" | "speed_kt") => void;
}

/**
 * The primary flight display: the modes, the horizon between the tapes of speed and altitude, the heading, and six numbers. A
 * press on a tape asks for another target.
 */
export function PrimaryDisplay({ modes, onPlot, onTarget }: Props) {
  const { t } = useTranslation();
  const aircraft = useFlownAircraft();
  const six = SIX[aircraft];
  const target = TARGET[aircraft];
  const airspeed = six.airspeed(useTelemetry(isGpsSpeed));
  return (
    <aside className="fly-display" aria-label={t("fly.display")}>
      {modes}
      <div className="fly-primary">
        <LiveTape
          quantity="speed"
          scales={SPEED_TAPES}
          attribute="data-airspeed-kt"
          side="left"
          label={t("six.airspeed")}
          read={airspeed.read}
          target={target.speed_kt}
          press={{ label: t("fly.target.speed_kt"), onPress: () => onTarget("speed_kt") }}
        />
        <div className="fly-attitude">
          <LiveAttitude topic={six.attitude} />
        </div>
        <LiveTape
          quantity="altitude"
          scales={ALTITUDE_TAPES}
          attribute="data-altitude-ft"
          side="right"
          label={t("fly.altitude")}
          read={six.altimeterBaro.read}
          target={target.altitude_ft}
          press={{ label: t("fly.target.altitude_ft"), onPress: () => onTarget("altitude_ft") }}
        />
        <div className="fly-heading">
          <LiveHeading heading_deg={six.heading.read} bearing_deg={six.bearing_deg} />
        </div>
      </div>
      <Figures aircraft={aircraft} onPlot={onPlot} />
    </aside>
  );
}
