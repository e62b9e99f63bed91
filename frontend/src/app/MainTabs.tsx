import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { UnseenAlarms } from "../features/alarms/UnseenAlarms";
import { usePage } from "../store/hooks";
import { choose } from "../store/settings";
import { Tabs } from "../ui/Tabs";
import { AllTabs } from "./compact/AllTabs";
import { TabIcon } from "./compact/TabIcon";
import { LoadFailure } from "./dialogs";
import type { Layout } from "./layout";
import { TABS, type TabName, useOpenTab, VIEWS } from "./views/views";

/** In a bar that does not hold all tabs, what is needed in flight comes first. */
const FIRST_IN_BAR = ["fly", "map", "plans", "alarms"] as const satisfies readonly TabName[];
const BAR: readonly TabName[] = [
  ...FIRST_IN_BAR,
  ...TABS.filter((tab) => !FIRST_IN_BAR.some((one) => one === tab)),
];

/** The main tabs; the one last open is remembered. */
export function MainTabs({ layout }: { readonly layout: Layout }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const isWide = layout === "wide";
  return (
    <Tabs
      label={t("app.tabs")}
      size="main"
      className="app-tabs"
      orientation={layout === "beside" ? "vertical" : "horizontal"}
      value={useOpenTab()}
      onValueChange={(tab) => choose(settings, "tab", tab)}
      trailing={isWide ? undefined : <AllTabs tabs={BAR} />}
      tabs={(isWide ? TABS : BAR).map((tab) => ({
        value: tab,
        label: t(`tab.${tab}`),
        icon: isWide ? undefined : <TabIcon tab={tab} />,
        badge: tab === "alarms" ? <UnseenAlarms /> : undefined,
        content: <View tab={tab} />,
      }))}
    />
  );
}

/** What a tab shows. */
export function View({ tab }: { tab: TabName }) {
  const { t } = useTranslation();
  const { Part } = VIEWS[tab];
  return <Part waiting={<p className="app-waiting">{t("window.loading")}</p>} failed={NotLoaded} />;
}

function NotLoaded(retry: () => void): ReactNode {
  return <LoadFailure onRetry={retry} />;
}
