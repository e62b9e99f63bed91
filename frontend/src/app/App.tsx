import { useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useSettings } from "../store/hooks";
import { applyTheme } from "../theme/theme";
import { WordsProvider } from "../ui/words";
import { Alarms } from "./Alarms";
import "./app.css";
import { Header } from "./Header";
import { LeftPanel } from "./LeftPanel";
import { MainTabs } from "./MainTabs";
import { StatusBar } from "./StatusBar";
import { Toolbars } from "./Toolbars";

/** The window's frame: header, toolbars, alarms, left panel and main tabs, status bar. */
export function App() {
  const { t, i18n } = useTranslation();
  const language = useSettings((settings) => settings.language);
  const theme = useSettings((settings) => settings.theme);
  useEffect(() => {
    void i18n.changeLanguage(language);
    document.documentElement.lang = language;
  }, [i18n, language]);
  useEffect(() => applyTheme(document.documentElement, theme), [theme]);
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
    }),
    [t],
  );
  return (
    <WordsProvider words={words}>
      <div className="app">
        <header>
          <Header />
          <div className="app-toolbars">
            <Toolbars />
          </div>
        </header>
        <Alarms />
        <div className="app-body">
          <LeftPanel />
          <main className="app-main">
            <MainTabs />
          </main>
        </div>
        <StatusBar />
      </div>
    </WordsProvider>
  );
}
