import { type ReactNode, useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { ControlsPanel } from "../../features/controls/ControlsPanel";
import { LiveControlPath } from "../../features/controls/LiveControlPath";
import { usePage, useSettings } from "../../store/hooks";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { Toolbar } from "../../ui/Toolbar";
import { LanguageSwitch, ThemeSelect } from "../bars/Header";
import { LinkFigures } from "../bars/StatusBar";
import { Menus } from "../menu/Menus";
import { chooseTimeBar, isTimeBarShown } from "../settings/choices";
import { AutomaticControls, SignalControls } from "../toolbars/Toolbars";
import { useDialogs } from "../views/useDialogs";
import { useOpenTab } from "../views/views";
import "./drawer.css";

/** Everything for which a small window has no place: both toolbars, the pilot's controls, the menus, the links, the look. */
export function Drawer() {
  const { t } = useTranslation();
  useClosedByTab();
  return (
    <div className="drawer">
      <Section title={t("toolbar.automatic")}>
        <Toolbar label={t("toolbar.automatic")}>
          <AutomaticControls />
        </Toolbar>
      </Section>
      <Section title={t("toolbar.signal")}>
        <Toolbar label={t("toolbar.signal")}>
          <SignalControls />
        </Toolbar>
        <LiveControlPath />
      </Section>
      <Section title={t("menu.bar")}>
        <Menus orientation="vertical" />
      </Section>
      <ControlsPanel />
      <Section title={t("drawer.links")}>
        <div className="drawer-links">
          <LinkFigures />
        </div>
      </Section>
      <Section title={t("settings.look")}>
        <LanguageSwitch />
        <ThemeSelect />
        <TimeBarSwitch />
      </Section>
    </div>
  );
}

function Section({ title, children }: { readonly title: string; readonly children: ReactNode }) {
  return (
    <section className="drawer-section" aria-label={title}>
      <h3>{title}</h3>
      {children}
    </section>
  );
}

function TimeBarSwitch() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <SegmentedSwitch
      label={t("time.label")}
      options={[
        { value: "shown", label: t("drawer.shown") },
        { value: "folded", label: t("drawer.folded") },
      ]}
      value={useSettings(isTimeBarShown) ? "shown" : "folded"}
      onChange={(value) => chooseTimeBar(settings, value === "shown")}
    />
  );
}

/** A menu entry that opens a tab must show it. */
function useClosedByTab(): void {
  const { close } = useDialogs();
  const tab = useOpenTab();
  const before = useRef(tab);
  useEffect(() => {
    if (before.current !== tab) {
      close();
    }
  }, [tab, close]);
}
