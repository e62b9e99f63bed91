import { type ComponentProps, type ReactNode, useEffect, useMemo, useRef } from "react";
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
import { RefusalProvider } from "../ui/refusal";
import { WordsProvider } from "../ui/words";
import "./app.css";
import "./compact/compact.css";
import { SourceBanner } from "../features/controls/SourceBanner";
import { EmulationBanner } from "../features/emulation/EmulationBanner";
import { Header } from "./bars/Header";
import { PresentPage } from "./bars/presentPage";
import { MessageRow, StatusBar } from "./bars/StatusBar";
import { FlightInstruments } from "./compact/FlightInstruments";
import { Strip } from "./compact/Strip";
import { DialogsProvider, FIRST_START_PAGE, FieldWished, LoadFailure } from "./dialogs";
import { FlightDisplay } from "./FlightDisplay";
import { FIRST_START } from "./firstStart/firstStart";
import { LeftPanel } from "./LeftPanel";
import { type Layout, useLayout, useLayoutOnDocument } from "./layout";
import { MainTabs } from "./MainTabs";
import { SHOWN } from "./past";
import { areKeysOn, isTimeBarShown, motionOf } from "./settings/choices";
import { Shortcuts } from "./shortcuts/Shortcuts";
import { ScreenStick, Tuning } from "./Tuning";
import { Dock } from "./toolbars/Dock";
import { MovedContext } from "./toolbars/MovableToolbar";
import { useLeaveWarning } from "./useLeaveWarning";
import { ENTER_PAGE, useOpenTab } from "./views/views";
import { WindowTitle } from "./WindowTitle";

/** The whole page: the way in for a stranger, the window for everybody else. */
export function App() {
  const isOut = useAdmission(({ state }) => state === "stranger" || state === "waiting");
  useLook();
  return (
    <Shared>
      {isOut ? (
        <ENTER_PAGE.Part waiting={null} failed={(retry) => <LoadFailure onRetry={retry} />} />
      ) : (
        <Window />
      )}
    </Shared>
  );
}

/** What every part of the page finds around it: the controls' words, and who answers a press that does nothing. */
export function Shared({ children }: { children: ReactNode }) {
  return (
    <WordsProvider words={useSharedWords()}>
      <RefusalProvider value={usePage().messages.refuse}>{children}</RefusalProvider>
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
      whichNumber: t("words.whichNumber"),
      outOfRange: (minimum: string, maximum: string) => t("words.outOfRange", { minimum, maximum }),
      stillIs: (value: string) => t("words.stillIs", { value }),
      refusedEdit: (text: string, why: string) => t("words.refusedEdit", { text, why }),
      openEdit: (label: string) => t("words.openEdit", { label }),
    }),
    [t, isPast],
  );
}

/**
 * Header, toolbars, alarms, left panel and main tabs, time bar, status bar; in a small window a strip, the instruments that
 * fly and the open tab, and all else in a drawer. Alarms, the time bar and the strip of the present are always of the
 * present; all else reads the page that is shown. The open tab is the same element in every layout: a window that is
 * turned or zoomed begins nothing anew.
 */
function Window() {
  const present = usePage();
  const shown = useStore(usePart(SHOWN), ({ page }) => page);
  const isPast = shown.past !== null;
  const layout = useLayout();
  const isWide = layout === "wide";
  useLayoutOnDocument(layout);
  const hasKeys = useSettings(areKeysOn);
  const hasTimeBar = useSettings(isTimeBarShown);
  useLeaveWarning();
  const moved = useRef<string | null>(null);
  return (
    <PageContext value={shown}>
      <PresentPage value={present}>
        <DialogsProvider>
          <MovedContext value={moved}>
            <WindowTitle />
            <div
              className="app"
              data-past={isPast}
              data-layout={layout}
              data-time={isWide || isPast || hasTimeBar ? "shown" : "folded"}
            >
              <header className="app-top">
                <PageContext value={present}>{isPast && <PresentStrip />}</PageContext>
                {isWide ? <Header present={present} /> : <Strip present={present} />}
              </header>
              {isWide && <Dock edge="top" />}
              <div className="app-warnings">
                <PageContext value={present}>
                  <AccessBands />
                </PageContext>
                <EmulationBanner />
                <AhrsTestBanner />
                <SourceBanner />
                <PageContext value={present}>
                  <AlarmBar isBesidePast={isPast} />
                </PageContext>
              </div>
              <div className="app-middle">
                {isWide && <Dock edge="left" />}
                <Body layout={layout} />
                {isWide && <Dock edge="right" />}
              </div>
              {isWide && <Dock edge="bottom" />}
              <PageContext value={present}>
                <TimeBar hasKeys={hasKeys} />
              </PageContext>
              {isWide ? <StatusBar /> : <MessageRow />}
              {isWide && <Dock edge="floating" />}
            </div>
            <Shortcuts />
            <FieldWished />
          </MovedContext>
        </DialogsProvider>
      </PresentPage>
    </PageContext>
  );
}

/** The open tab and what stands beside it; of a new station, what that has to know first. */
function Body({ layout }: { readonly layout: Layout }) {
  const { key, past } = usePage();
  const tab = useOpenTab();
  const isFirstStart = useStore(usePart(FIRST_START).store, ({ isShown }) => isShown);
  if (isFirstStart && past === null) {
    return <FIRST_START_PAGE.Part waiting={null} failed={(retry) => <LoadFailure onRetry={retry} />} />;
  }
  return (
    // Another page, other components: nothing that one of them remembers is of the other page.
    <div className="app-body" key={key}>
      {tab === "fly" ? <FlightDisplay /> : layout === "wide" ? <LeftPanel /> : <FlightInstruments />}
      <main className="app-main">
        <MainTabs layout={layout} />
        <Tuning />
        <ScreenStick />
      </main>
    </div>
  );
}
