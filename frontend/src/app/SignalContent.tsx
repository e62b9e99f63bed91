import { useTranslation } from "react-i18next";
import { LiveControlPath } from "../features/controls/LiveControlPath";
import { Toolbar } from "../ui/Toolbar";
import { AutomaticControls, SignalControls } from "./toolbars/Toolbars";
import "./signal.css";

/** The path of the control signal, with the switches that change it. */
export function SignalContent() {
  const { t } = useTranslation();
  return (
    <div className="signal">
      <LiveControlPath />
      <Toolbar label={t("toolbar.signal")}>
        <SignalControls />
      </Toolbar>
      <Toolbar label={t("toolbar.automatic")}>
        <AutomaticControls />
      </Toolbar>
    </div>
  );
}
