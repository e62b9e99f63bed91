import { useTranslation } from "react-i18next";
import { Panel } from "../../ui/Panel";
import { useGlobe } from "./useGlobe";

/** Where the globe is seen from. */
export function CameraSection() {
  const { t } = useTranslation();
  const globe = useGlobe();
  return <Panel title={t("map.view.camera")}>{globe === null && <p>{t("map.view.loading")}</p>}</Panel>;
}
