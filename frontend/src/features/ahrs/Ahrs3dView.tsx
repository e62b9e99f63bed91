import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Tabs } from "../../ui/Tabs";
import { AttitudeTab } from "./AttitudeTab";
import "./ahrs3d.css";
import { CalibrationTab } from "./CalibrationTab";

const TABS = ["attitude", "calibration"] as const;

/** "AHRS 3D": the aircraft that turns as the board turns, and the calibration of its magnetometer. */
export function Ahrs3dView() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const open = useSettings(({ choices }) => TABS.find((tab) => tab === choices["ahrs3dTab"]) ?? "attitude");
  return (
    <div className="ahrs3d">
      <Tabs
        label={t("tab.ahrs3d")}
        className="ahrs3d-tabs"
        value={open}
        onValueChange={(tab) => choose(settings, "ahrs3dTab", tab)}
        tabs={[
          { value: "attitude", label: t("ahrs3d.tabAttitude"), content: <AttitudeTab /> },
          { value: "calibration", label: t("ahrs3d.tabCalibration"), content: <CalibrationTab /> },
        ]}
      />
    </div>
  );
}
