import { useTranslation } from "react-i18next";
import { AttitudeTab } from "./AttitudeTab";
import "./ahrs3d.css";

/** "AHRS 3D": the aircraft that turns as the board turns. */
export function Ahrs3dView() {
  const { t } = useTranslation();
  return (
    <div className="ahrs3d">
      <h2 className="visually-hidden">{t("tab.ahrs3d")}</h2>
      <AttitudeTab />
    </div>
  );
}
