import { Menu } from "lucide-react";
import { useTranslation } from "react-i18next";
import { type Page, PageContext } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Control } from "../bars/Header";
import { LinkState } from "../bars/StatusBar";
import { useDialogs } from "../views/useDialogs";

/** Top row of a small window: the drawer with everything in it, the board's link, who has control. */
export function Strip({ present }: { readonly present: Page }) {
  const { t } = useTranslation();
  const { open } = useDialogs();
  return (
    <div className="app-strip">
      <h1 className="visually-hidden">{t("app.name")}</h1>
      <Button
        label={t("app.drawer")}
        icon={<Menu size={20} aria-hidden="true" />}
        onPress={() => open("drawer")}
      >
        {""}
      </Button>
      <LinkState />
      <PageContext value={present}>
        <Control />
      </PageContext>
    </div>
  );
}
