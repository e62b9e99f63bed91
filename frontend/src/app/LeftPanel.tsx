import { useTranslation } from "react-i18next";
import { ControlsPanel } from "../features/controls/ControlsPanel";
import { LiveControlPath } from "../features/controls/LiveControlPath";
import { heading, tenths } from "../readouts/formats";
import { LiveAttitude } from "../readouts/LiveAttitude";
import { boardBearing_deg, boardHeading_deg, LiveHeading } from "../readouts/LiveHeading";
import { LiveReadout } from "../readouts/LiveReadout";
import { StreamPanel } from "../readouts/StreamPanel";
import { ReadoutGrid } from "../ui/Readout";
import "./left-panel.css";

/** Attitude over heading, their numbers, and the controls of the chosen source: always in sight. */
export function LeftPanel() {
  const { t } = useTranslation();
  const deg = t("unit.deg");
  return (
    <aside className="left" aria-label={t("left.label")}>
      <div className="left-dials">
        <LiveAttitude topic="ahrs" />
        <LiveHeading heading_deg={boardHeading_deg} bearing_deg={boardBearing_deg} />
      </div>
      <div className="left-numbers">
        <StreamPanel topic="ahrs" title={t("left.ahrs")} className="left-ahrs" narrow plain>
          <ReadoutGrid>
            <LiveReadout
              topic="ahrs"
              field="yaw_deg"
              format={heading}
              label={t("attitude.heading")}
              unit={deg}
              size="large"
              chars={5}
            />
            <LiveReadout
              topic="ahrs"
              field="pitch_deg"
              format={tenths}
              label={t("attitude.pitch")}
              unit={deg}
              size="large"
              chars={5}
            />
            <LiveReadout
              topic="ahrs"
              field="roll_deg"
              format={tenths}
              label={t("attitude.roll")}
              unit={deg}
              size="large"
              chars={5}
            />
          </ReadoutGrid>
        </StreamPanel>
        <ControlsPanel />
      </div>
      <LiveControlPath />
    </aside>
  );
}
