import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../store/hooks";
import { choose } from "../store/settings";
import { Tabs } from "../ui/Tabs";
import { FlightView } from "../views/flight/FlightView";
import { HilView } from "../views/hil/HilView";
import { SetupView } from "../views/setup/SetupView";

/** The main tabs in the order in which they stand. */
export const TABS = ["flight", "hil", "setup"] as const;
export type TabName = (typeof TABS)[number];

const CONTENTS: Readonly<Record<TabName, () => React.ReactNode>> = {
  flight: () => <FlightView />,
  hil: () => <HilView />,
  setup: () => <SetupView />,
};

/** The main tabs; the one last open is remembered. */
export function MainTabs() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const chosen = useSettings(({ choices }) => TABS.find((tab) => tab === choices["tab"]) ?? "flight");
  return (
    <Tabs
      label={t("app.tabs")}
      size="main"
      className="app-tabs"
      value={chosen}
      onValueChange={(tab) => choose(settings, "tab", tab)}
      tabs={TABS.map((tab) => ({ value: tab, label: t(`tab.${tab}`), content: CONTENTS[tab]() }))}
    />
  );
}
