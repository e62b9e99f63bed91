import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../store/hooks";
import { choose } from "../store/settings";
import { Tabs } from "../ui/Tabs";
import { LoadFailure } from "./dialogs/dialogs";
import { TABS, type TabName, VIEWS } from "./views";

/** The tab that is open: the one last chosen. */
export function useOpenTab(): TabName {
  return useSettings(({ choices }) => TABS.find((tab) => tab === choices["tab"]) ?? "flight");
}

/** The main tabs; the one last open is remembered. */
export function MainTabs() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <Tabs
      label={t("app.tabs")}
      size="main"
      className="app-tabs"
      value={useOpenTab()}
      onValueChange={(tab) => choose(settings, "tab", tab)}
      tabs={TABS.map((tab) => ({ value: tab, label: t(`tab.${tab}`), content: <View tab={tab} /> }))}
    />
  );
}

function View({ tab }: { tab: TabName }) {
  const { t } = useTranslation();
  const { Part } = VIEWS[tab];
  return <Part waiting={<p className="app-waiting">{t("window.loading")}</p>} failed={NotLoaded} />;
}

function NotLoaded(retry: () => void): ReactNode {
  return <LoadFailure onRetry={retry} />;
}
