import { type ComponentProps, useEffect, useMemo, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { AccessBands } from "../features/access/AccessBands";
import { AhrsTestBanner } from "../features/ahrs/AhrsTestBanner";
import { AlarmBar } from "../features/alarms/AlarmBar";
import { PresentStrip } from "../features/playback/PresentStrip";
import { TimeBar } from "../features/playback/TimeBar";
import { useAdmission } from "../requests/useRole";
import { PageContext, usePage, usePart, useSettings } from "../store/hooks";
import { applyTheme } from "../theme/theme";
import { WordsProvider } from "../ui/words";
import "./app.css";
import "./phone.css";
import { SourceBanner } from "../features/controls/SourceBanner";
import { EmulationBanner } from "../features/emulation/EmulationBanner";
import { DialogsProvider, LoadFailure } from "./dialogs/dialogs";
import { Header } from "./Header";
import { LeftPanel } from "./LeftPanel";
import { MainTabs } from "./MainTabs";
import { motionOf } from "./motion";
import { SHOWN } from "./past";
import { StatusBar } from "./StatusBar";
import { areKeysOn } from "./shortcuts/choice";
import { Shortcuts } from "./shortcuts/Shortcuts";
import { Tuning } from "./Tuning";
import { Dock } from "./toolbars/Dock";
import { MovedContext } from "./toolbars/MovableToolbar";
import { useLeaveWarning } from "./useLeaveWarning";
import { useTitle } from "./useTitle";
import { ENTER_PAGE } from "./views";

/** The whole page: the way in for a stranger, the window for everybody else. */
export function App() {
  const isOut = useAdmission(({ state }) => state === "stranger" || state === "waiting");
  useLook();
  const words = useSharedWords();
  return (
    <WordsProvider words={words}>
      {isOut ? (
        <ENTER_PAGE.Part waiting={null} failed={(retry) => <LoadFailure onRetry={retry} />} />
      ) : (
        <Window />
      )}
    </WordsProvider>
  );
}

/** Language, theme and motion as chosen, on the document. */
function useLook(): void {
  const { i18n } = useTranslation();
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
}

function useSharedWords(): ComponentProps<typeof WordsProvider>["words"] {
  const { t } = useTranslation();
  const isPast = useStore(usePart(SHOWN), ({ page }) => page.past !== null);
  return useMemo(
    () => ({
      live: t(isPast ? "words.past" : "words.live"),
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
    [t, isPast],
  );
}

/**
 * Header, toolbars, alarms, left panel and main tabs, time bar, status bar. Alarms, the time bar and the strip of the
 * present are always of the present; all else reads the page that is shown.
 */
function Window() {
  const present = usePage();
  const shown = useStore(usePart(SHOWN), ({ page }) => page);
  const isPast = shown.past !== null;
  useTitle();
  const hasKeys = useSettings(areKeysOn);
  useLeaveWarning();
  const moved = useRef<string | null>(null);
  return (
    <PageContext value={shown}>
      <DialogsProvider>
        <MovedContext value={moved}>
          <div className="app" data-past={isPast}>
            <header className="app-top">
              <PageContext value={present}>{isPast && <PresentStrip />}</PageContext>
              <Header present={present} />
            </header>
            <Dock edge="top" />
            <div className="app-warnings">
              <PageContext value={present}>
                <AccessBands />
              </PageContext>
              <EmulationBanner />
              <AhrsTestBanner />
              <SourceBanner />
              <PageContext value={present}>
                <AlarmBar />
              </PageContext>
            </div>
            <div className="app-middle">
              <Dock edge="left" />
              {/* Another page, other components: nothing that one of them remembers is of the other page. */}
              <div className="app-body" key={shown.key}>
                <LeftPanel />
                <main className="app-main">
                  <MainTabs />
                  <Tuning />
                </main>
              </div>
              <Dock edge="right" />
            </div>
            <Dock edge="bottom" />
            <PageContext value={present}>
              <TimeBar hasKeys={hasKeys} />
            </PageContext>
            <StatusBar present={present} />
            <Dock edge="floating" />
          </div>
          <Shortcuts />
        </MovedContext>
      </DialogsProvider>
    </PageContext>
  );
}
