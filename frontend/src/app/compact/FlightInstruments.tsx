import { useRef } from "react";
import { useTranslation } from "react-i18next";
import { readAutopilot, readAutotrim } from "../../features/controls/axes";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { LiveFlag } from "../../readouts/LiveFlag";
import { boardBearing_deg, boardHeading_deg, LiveHeading } from "../../readouts/LiveHeading";
import { LiveReadout } from "../../readouts/LiveReadout";
import { HEADING } from "../../readouts/notations";
import { ReadoutGrid } from "../../ui/Readout";
import { useScrolledByKey } from "../../ui/useScrolledByKey";
import "./flying.css";

/** What the aircraft is flown by, in a small window: attitude, heading, speeds, altitude, and whether it flies by itself. */
export function FlightInstruments() {
  const { t } = useTranslation();
  const panel = useRef<HTMLElement>(null);
  useScrolledByKey(panel);
  return (
    <aside ref={panel} className="flying" aria-label={t("left.label")}>
      <div className="flying-dials">
        <LiveAttitude topic="ahrs" />
        <LiveHeading heading_deg={boardHeading_deg} bearing_deg={boardBearing_deg} />
      </div>
      <div className="flying-numbers">
        <ReadoutGrid>
          <LiveReadout
            topic="analog"
            field="calibrated_airspeed_kt"
            chars={5}
            label="flying.airspeed"
            as="speed"
          />
          <LiveReadout topic="gps" field="speed_kt" chars={5} label="flying.groundSpeed" as="speed" />
          <LiveReadout topic="analog" field="altitude_m" chars={5} label="analog.altitude" as="altitude" />
          <LiveReadout topic="ahrs" field="yaw_deg" chars={5} label="attitude.heading" as={HEADING} />
        </ReadoutGrid>
        <div className="flying-flags">
          <LiveFlag topic="heartbeat" read={readAutopilot} label={t("flag.autopilot")} />
          <LiveFlag topic="heartbeat" read={readAutotrim} label={t("flag.autotrim")} />
        </div>
      </div>
    </aside>
  );
}
