import { useTranslation } from "react-i18next";
import { MenuBar } from "../../ui/MenuBar";
import { AircraftMenu } from "./AircraftMenu";
import { AutopilotMenu } from "./AutopilotMenu";
import { EarthMenu } from "./EarthMenu";
import { HelpMenu } from "./HelpMenu";
import { ParametersMenu } from "./ParametersMenu";
import { ViewMenu } from "./ViewMenu";
import { XPlaneMenu } from "./XPlaneMenu";

/** The menus in the order in which the station's users know them. */
export function Menus({ orientation }: { readonly orientation?: "horizontal" | "vertical" }) {
  const { t } = useTranslation();
  return (
    <MenuBar label={t("menu.bar")} orientation={orientation}>
      <AutopilotMenu />
      <ParametersMenu />
      <EarthMenu />
      <AircraftMenu />
      <XPlaneMenu />
      <ViewMenu />
      <HelpMenu />
    </MenuBar>
  );
}
