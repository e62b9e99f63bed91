import { Ellipsis } from "lucide-react";
import { useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { usePage } from "../../store/hooks";
import { choose } from "../../store/settings";
import { AnchoredMenu, MenuChoice } from "../../ui/MenuBar";
import type { TabName } from "../views/views";
import { useOpenTab } from "../views/views";

/** The last place of a bar that does not hold all tabs: all of them in a menu. */
export function AllTabs({ tabs }: { readonly tabs: readonly TabName[] }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const open = useOpenTab();
  const button = useRef<HTMLButtonElement>(null);
  const home = useRef<HTMLDivElement>(null);
  const [isOpen, setOpen] = useState(false);
  return (
    <div ref={home} className="app-all-tabs">
      <button
        ref={button}
        type="button"
        className="ui-tab"
        aria-haspopup="menu"
        aria-expanded={isOpen}
        aria-label={t("app.allTabs")}
        onClick={() => setOpen((before) => !before)}
      >
        <Ellipsis size={20} aria-hidden="true" />
        <span className="ui-tab-label">{t("app.more")}</span>
      </button>
      {isOpen && (
        <AnchoredMenu anchor={button} home={home} onClose={() => setOpen(false)}>
          <MenuChoice
            label={t("app.tabs")}
            options={tabs.map((value) => ({ value, label: t(`tab.${value}`) }))}
            value={open}
            onChange={(tab) => {
              setOpen(false);
              choose(settings, "tab", tab);
            }}
          />
        </AnchoredMenu>
      )}
    </div>
  );
}
