import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../../store/hooks";
import { choose, LANGUAGES } from "../../store/settings";
import { THEMES } from "../../theme/theme";
import { Menu, MenuAction, MenuChoice, MenuRule } from "../../ui/MenuBar";
import { BARS } from "../toolbars/Dock";
import { placeKey } from "../toolbars/MovableToolbar";
import { placeText } from "../toolbars/places";
import { useDialogs } from "../views/useDialogs";

export function ViewMenu() {
  const { t } = useTranslation();
  return (
    <Menu label={t("menu.view")}>
      <Theme />
      <MenuRule />
      <Language />
      <MenuRule />
      <LogItem />
      <ChecklistItem />
      <FieldItem />
      <TabletItem />
      <ToolbarsBack />
      <SettingsItem />
    </Menu>
  );
}

function Theme() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <MenuChoice
      label={t("app.theme")}
      options={THEMES.map((value) => ({ value, label: t(`theme.${value}`) }))}
      value={useSettings(({ theme }) => theme)}
      onChange={(theme) => settings.setState({ theme })}
    />
  );
}

function Language() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <MenuChoice
      label={t("app.language")}
      options={LANGUAGES.map((value) => ({ value, label: t(`language.${value}`) }))}
      value={useSettings(({ language }) => language)}
      onChange={(language) => settings.setState({ language })}
    />
  );
}

function ToolbarsBack() {
  const { t } = useTranslation();
  const { settings } = usePage();
  return (
    <MenuAction
      label={t("menu.toolbarsBack")}
      onChoose={() => {
        for (const name of BARS) {
          choose(settings, placeKey(name), placeText({ edge: "top" }));
        }
      }}
    />
  );
}

function LogItem() {
  const { t } = useTranslation();
  const { open } = useDialogs();
  return <MenuAction label={t("menu.log")} aside="L" onChoose={() => open("log")} />;
}

function FieldItem() {
  const { t } = useTranslation();
  const { open } = useDialogs();
  return <MenuAction label={t("menu.field")} onChoose={() => open("field")} />;
}

function ChecklistItem() {
  const { t } = useTranslation();
  const { open } = useDialogs();
  return <MenuAction label={t("menu.checklist")} onChoose={() => open("checklist")} />;
}

function TabletItem() {
  const { t } = useTranslation();
  const { open } = useDialogs();
  return <MenuAction label={t("menu.tablet")} onChoose={() => open("tablet")} />;
}

function SettingsItem() {
  const { t } = useTranslation();
  const { open } = useDialogs();
  return <MenuAction label={t("menu.settings")} aside="," onChoose={() => open("settings")} />;
}
