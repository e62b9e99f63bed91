import { useTranslation } from "react-i18next";
import { Menu, MenuAction } from "../../ui/MenuBar";
import { useDialogs } from "../views/useDialogs";

export function HelpMenu() {
  const { t } = useTranslation();
  const { open } = useDialogs();
  return (
    <Menu label={t("menu.help")}>
      <MenuAction label={t("menu.guide")} onChoose={() => open("guide")} />
      <MenuAction label={t("menu.shortcuts")} aside="?" onChoose={() => open("shortcuts")} />
      <MenuAction label={t("menu.about")} onChoose={() => open("about")} />
    </Menu>
  );
}
