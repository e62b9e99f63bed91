import { useRef } from "react";
import { useTranslation } from "react-i18next";
import { ControlsPanel } from "../features/controls/ControlsPanel";
import { LiveControlPath } from "../features/controls/LiveControlPath";
import { LiveAttitude } from "../readouts/LiveAttitude";
import { boardBearing_deg, boardHeading_deg, LiveHeading } from "../readouts/LiveHeading";
import { ReadoutPanel } from "../readouts/ReadoutTable";
import { ATTITUDE } from "../readouts/rows";
import { useScrolledByKey } from "../ui/useScrolledByKey";
import "./left-panel.css";

/** Attitude over heading, their numbers, and the controls of the chosen source: always in sight. */
export function LeftPanel() {
  const { t } = useTranslation();
  const panel = useRef<HTMLElement>(null);
  useScrolledByKey(panel);
  return (
    <aside ref={panel} className="left" aria-label={t("left.label")}>
      <div className="left-dials">
        <LiveAttitude topic="ahrs" />
        <LiveHeading heading_deg={boardHeading_deg} bearing_deg={boardBearing_deg} />
      </div>
      <div className="left-numbers">
        <ReadoutPanel
          {...ATTITUDE}
          titleKey="left.ahrs"
          hintKey="termHint.ahrs"
          className="left-ahrs"
          size="large"
          chars={5}
          narrow
          plain
        />
        <ControlsPanel />
      </div>
      <LiveControlPath />
    </aside>
  );
}
