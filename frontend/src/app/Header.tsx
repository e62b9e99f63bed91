import { useTranslation } from "react-i18next";
import { usePlayback } from "../features/playback/usePlayback";
import { ACTIONS } from "../requests/actions";
import { useAsked } from "../requests/useAsked";
import { type Page, PageContext, useConnection, usePage, usePart, useSettings } from "../store/hooks";
import { LANGUAGES } from "../store/settings";
import { THEMES } from "../theme/theme";
import { Button } from "../ui/Button";
import { SegmentedSwitch } from "../ui/SegmentedSwitch";
import { Select } from "../ui/Select";
import { Menus } from "./menu/Menus";

/** Top row: title, menus, who has control now, language and theme. */
export function Header({ present }: { present: Page }) {
  const { t } = useTranslation();
  return (
    <div className="app-header">
      <h1 className="app-brand">
        <span className="app-brand-mark" aria-hidden="true" />
        <span className="app-brand-name">{t("app.name")}</span>
      </h1>
      <Menus />
      <div className="app-header-right">
        <PageContext value={present}>
          <ControlHolder />
        </PageContext>
        <LanguageSwitch />
        <ThemeSelect />
      </div>
    </div>
  );
}

/** Who may command; with the button that takes control while nobody has it, or gives it back. */
function ControlHolder() {
  const { t } = useTranslation();
  const actions = usePart(ACTIONS);
  const { state, stateText } = useAsked("control");
  const isPast = usePlayback(({ flight }) => flight !== null);
  const past = isPast ? t("blocked.past") : undefined;
  const isOpen = useConnection(({ phase }) => phase === "open");
  const control = useConnection(({ status }) => status?.control ?? null);
  const client = useConnection((connection) => connection.client);
  if (!isOpen || control === null) {
    return <p className="app-control">{t("control.unknown")}</p>;
  }
  if (control.client === client) {
    return (
      <div className="app-control">
        <p className="app-control-mine">{t("control.mine")}</p>
        <Button
          onPress={() => void actions.releaseControl({ control: "control" })}
          state={state}
          stateText={stateText}
          disabledReason={past}
        >
          {t("control.release")}
        </Button>
      </div>
    );
  }
  const holder = control.client === null ? null : (control.name ?? control.client);
  return (
    <div className="app-control">
      <p>{holder === null ? t("control.free") : t("control.other", { name: holder })}</p>
      <Button
        onPress={() => void actions.takeControl({ control: "control" })}
        state={state}
        stateText={stateText}
        disabledReason={past ?? (holder === null ? undefined : t("blocked.held", { name: holder }))}
      >
        {t("control.take")}
      </Button>
    </div>
  );
}

function LanguageSwitch() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const language = useSettings((chosen) => chosen.language);
  return (
    <SegmentedSwitch
      label={t("app.language")}
      hideLabel
      options={LANGUAGES.map((value) => ({ value, label: t(`language.${value}`) }))}
      value={language}
      onChange={(value) => settings.setState({ language: value })}
    />
  );
}

function ThemeSelect() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const theme = useSettings((chosen) => chosen.theme);
  return (
    <Select
      label={t("app.theme")}
      hideLabel
      options={THEMES.map((value) => ({ value, label: t(`theme.${value}`) }))}
      value={theme}
      onChange={(value) => settings.setState({ theme: value })}
      placeholder={t("app.theme")}
    />
  );
}
