import { type RefObject, useRef } from "react";
import { useTranslation } from "react-i18next";
import { AnchoredMenu, MenuChoice } from "../../ui/MenuBar";
import type { TabGroup, TabName } from "../views/views";

interface Props {
  readonly group: TabGroup;
  readonly tab: TabName;
  /** The pressed group in the bar. */
  readonly pressed: RefObject<HTMLElement | null>;
  readonly onOpen: (tab: TabName) => void;
  readonly onClose: () => void;
}

/** The tabs of the open group, over its place in the bar. */
export function GroupMenu({ group, tab, pressed, onOpen, onClose }: Props) {
  const { t } = useTranslation();
  const home = useRef<HTMLDivElement>(null);
  const tabs: readonly TabName[] = group.tabs;
  return (
    <div ref={home}>
      <AnchoredMenu anchor={pressed} home={home} onClose={onClose}>
        <MenuChoice
          label={t("app.tabsOf", { group: t(`tabGroup.${group.name}`) })}
          options={tabs.map((value) => ({ value, label: t(`tab.${value}`) }))}
          value={tab}
          onChange={(one) => {
            onClose();
            onOpen(one);
          }}
        />
      </AnchoredMenu>
    </div>
  );
}
