import { useEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { AhrsTestBanner } from "../features/ahrs/AhrsTestBanner";
import { AlarmBar } from "../features/alarms/AlarmBar";
import { useSettings } from "../store/hooks";
import { applyTheme } from "../theme/theme";
import { WordsProvider } from "../ui/words";
import "./app.css";
import { SourceBanner } from "../features/controls/SourceBanner";
import { EmulationBanner } from "../features/emulation/EmulationBanner";
import { DialogsProvider } from "./dialogs/dialogs";
import { Header } from "./Header";
import { LeftPanel } from "./LeftPanel";
import { MainTabs } from "./MainTabs";
import { motionOf } from "./motion";
import { StatusBar } from "./StatusBar";
import { Shortcuts } from "./shortcuts/Shortcuts";
import { Tuning } from "./Tuning";
import { Dock } from "./toolbars/Dock";
import { MovedContext } from "./toolbars/MovableToolbar";
import { useLeaveWarning } from "./useLeaveWarning";
import { useTitle } from "./useTitle";

/** The whole window: header, toolbars, alarms, left panel and main tabs, status bar. */
export function App() {
  const { t, i18n } = useTranslation();
  const language = useSettings((settings) => settings.language);
  const theme = useSettings((settings) => settings.theme);
  useEffect(() => {
    void i18n.changeLanguage(language);
    document.documentElement.lang = language;
  }, [i18n, language]);
  useEffect(() => applyTheme(document.documentElement, theme), [theme]);
  const motion = useSettings(motionOf);
  useEffect(() => {
    document.documentElement.dataset["motion"] = motion;
  }, [motion]);
  useTitle();
  useLeaveWarning();
  const moved = useRef<string | null>(null);
  const words = useMemo(
    () => ({
      live: t("words.live"),
      stale: t("words.stale"),
      noData: t("words.noData"),
      pending: t("words.pending"),
      confirmed: t("words.confirmed"),
      rejected: t("words.rejected"),
      timedOut: t("words.timedOut"),
      sent: t("words.sent"),
      on: t("words.on"),
      off: t("words.off"),
      unknown: t("words.unknown"),
      increase: t("words.increase"),
      decrease: t("words.decrease"),
      dismiss: t("words.dismiss"),
      close: t("words.close"),
      warning: t("words.warning"),
      critical: t("words.critical"),
      notANumber: t("words.notANumber"),
      outOfRange: (minimum: string, maximum: string) => t("words.outOfRange", { minimum, maximum }),
      stillIs: (value: string) => t("words.stillIs", { value }),
      refusedEdit: (text: string, why: string) => t("words.refusedEdit", { text, why }),
    }),
    [t],
  );
  return (
    <WordsProvider words={words}>
      <DialogsProvider>
        <MovedContext value={moved}>
          <div className="app">
            <header className="app-top">
              <Header />
            </header>
            <Dock edge="top" />
            <div className="app-warnings">
              <EmulationBanner />
              <AhrsTestBanner />
              <SourceBanner />
              <AlarmBar />
            </div>
            <div className="app-middle">
              <Dock edge="left" />
              <div className="app-body">
                <LeftPanel />
                <main className="app-main">
                  <MainTabs />
                  <Tuning />
                </main>
              </div>
              <Dock edge="right" />
            </div>
            <Dock edge="bottom" />
            <StatusBar />
            <Dock edge="floating" />
          </div>
          <Shortcuts />
        </MovedContext>
      </DialogsProvider>
    </WordsProvider>
  );
}
