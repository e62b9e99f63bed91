import { useTranslation } from "react-i18next";
import { ControlHolder } from "../../features/access/ControlHolder";
import { usePlayback } from "../../features/playback/usePlayback";
import { type Page, PageContext, usePage, useSettings } from "../../store/hooks";
import { LANGUAGES } from "../../store/settings";
import { THEMES } from "../../theme/theme";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { Select } from "../../ui/Select";
import { Menus } from "../menu/Menus";

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
          <Control />
        </PageContext>
        <LanguageSwitch />
        <ThemeSelect />
      </div>
    </div>
  );
}

/** Nothing is asked of the present while the past is shown. */
export function Control() {
  const { t } = useTranslation();
  const isPast = usePlayback(({ flight }) => flight !== null);
  return <ControlHolder blocked={isPast ? t("blocked.past") : undefined} />;
}

export function LanguageSwitch() {
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

export function ThemeSelect() {
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
