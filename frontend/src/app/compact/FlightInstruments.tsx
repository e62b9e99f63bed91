import { useRef } from "react";
import { useTranslation } from "react-i18next";
import { isJoystick } from "../../features/controls/axes";
import { AutomaticFlags } from "../../readouts/AutomaticFlags";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { boardBearing_deg, boardHeading_deg, LiveHeading } from "../../readouts/LiveHeading";
import type { ReadoutLayout, ReadoutRows } from "../../readouts/LiveReadout";
import { Readouts } from "../../readouts/ReadoutTable";
import { YAW } from "../../readouts/rows";
import { useTelemetry } from "../../store/hooks";
import { ReadoutGrid } from "../../ui/Readout";
import { useScrolledByKey } from "../../ui/useScrolledByKey";
import "./flying.css";

type Instrument = ReadoutRows & ReadoutLayout;

const AIRSPEED: Instrument = {
  topic: "analog",
  chars: 5,
  rows: [{ field: "calibrated_airspeed_kt", label: "flying.airspeed", as: "speed" }],
};
const GROUND_SPEED: Instrument = {
  topic: "gps",
  chars: 5,
  rows: [{ field: "speed_kt", label: "flying.groundSpeed", as: "speed" }],
};
const ALTITUDE: Instrument = {
  topic: "analog",
  chars: 5,
  rows: [{ field: "altitude_m", label: "analog.altitude", as: "altitude" }],
};
const ATTITUDE_HEADING: Instrument = { topic: "ahrs", chars: 5, rows: [YAW] };

/** What the aircraft is flown by, in a small window: attitude, heading, speeds, altitude, and whether it flies by itself. */
export function FlightInstruments() {
  const { t } = useTranslation();
  const panel = useRef<HTMLElement>(null);
  useScrolledByKey(panel);
  const isHil = useTelemetry((telemetry) => isJoystick(telemetry));
  return (
    <aside ref={panel} className="flying" aria-label={t("left.label")}>
      <div className="flying-dials">
        <LiveAttitude topic="ahrs" />
        <LiveHeading heading_deg={boardHeading_deg} bearing_deg={boardBearing_deg} />
      </div>
      <div className="flying-numbers">
        <ReadoutGrid>
          <Readouts {...AIRSPEED} />
          <Readouts {...GROUND_SPEED} />
          <Readouts {...ALTITUDE} />
          <Readouts {...ATTITUDE_HEADING} />
        </ReadoutGrid>
        <div className="flying-flags">
          <AutomaticFlags of={isHil ? "hil" : "flight"} />
        </div>
      </div>
    </aside>
  );
}
