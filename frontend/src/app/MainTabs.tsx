import { type ReactNode, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { UnseenAlarms } from "../features/alarms/UnseenAlarms";
import { usePage } from "../store/hooks";
import { choose } from "../store/settings";
import { TabRow, Tabs } from "../ui/Tabs";
import { GroupIcon } from "./compact/GroupIcon";
import { GroupMenu } from "./compact/GroupMenu";
import { LoadFailure } from "./dialogs";
import type { Layout } from "./layout";
import {
  groupOf,
  lastTabOf,
  TAB_GROUPS,
  type TabGroup,
  type TabName,
  useOpenTab,
  VIEWS,
} from "./views/views";

/**
 * The groups of tabs; one opens where it was left. The tabs of the open one stand beside the groups, or, in a small window,
 * in a menu that a further press on the group opens.
 */
export function MainTabs({ layout }: { readonly layout: Layout }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const isWide = layout === "wide";
  const tab = useOpenTab();
  const open = groupOf(tab);
  const pressed = useRef<HTMLElement>(null);
  const [isMenuOpen, setMenuOpen] = useState(false);
  const show = (one: TabName): void => choose(settings, "tab", one);
  return (
    <Tabs
      label={t("app.tabs")}
      size="main"
      className="app-tabs"
      orientation={layout === "beside" ? "vertical" : "horizontal"}
      value={open.name}
      onValueChange={(name) => {
        const group = TAB_GROUPS.find((one) => one.name === name);
        if (group !== undefined) {
          show(lastTabOf(settings.getState(), group));
        }
      }}
      onPressAgain={(_, element) => {
        pressed.current = element;
        setMenuOpen(!isWide && open.tabs.length > 1);
      }}
      trailing={
        isWide
          ? open.tabs.length > 1 && <GroupTabs group={open} tab={tab} onOpen={show} />
          : isMenuOpen && (
              <GroupMenu
                group={open}
                tab={tab}
                pressed={pressed}
                onOpen={show}
                onClose={() => setMenuOpen(false)}
              />
            )
      }
      tabs={TAB_GROUPS.map((group) => {
        const hasMenu = !isWide && group.tabs.length > 1;
        const shown = group === open ? tab : lastTabOf(settings.getState(), group);
        return {
          value: group.name,
          label: t(`tabGroup.${group.name}`),
          icon: isWide ? undefined : <GroupIcon group={group.name} hasMenu={hasMenu} />,
          badge: group.name === "said" ? <UnseenAlarms /> : undefined,
          hasMenu,
          panelLabel: t(`tab.${shown}`),
          content: <View key={shown} tab={shown} />,
        };
      })}
    />
  );
}

function GroupTabs(props: {
  readonly group: TabGroup;
  readonly tab: TabName;
  readonly onOpen: (tab: TabName) => void;
}) {
  const { t } = useTranslation();
  const { group, tab, onOpen } = props;
  const tabs: readonly TabName[] = group.tabs;
  return (
    <TabRow
      label={t("app.tabsOf", { group: t(`tabGroup.${group.name}`) })}
      value={tab}
      onValueChange={onOpen}
      tabs={tabs.map((value) => ({
        value,
        label: t(`tab.${value}`),
        badge: value === "alarms" ? <UnseenAlarms /> : undefined,
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
