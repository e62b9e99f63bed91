import type { TFunction } from "i18next";
import { useTranslation } from "react-i18next";
import { TIME_KEYS } from "../../features/playback/timeKeys";
import { useSentence } from "../../i18n/useSentence";
import { useSettings } from "../../store/hooks";
import { Notice } from "../../ui/Notice";
import { areKeysOn } from "../settings/choices";
import { GROUPS, SHORTCUTS, type Shortcut } from "./table";
import "../views/dialogs.css";

/** The help sheet of the keys, written from the table that binds them. */
export function ShortcutsContent() {
  const { t } = useTranslation();
  const isOn = useSettings(areKeysOn);
  return (
    <div className="keys">
      {!isOn && <Notice level="warning">{t("shortcut.off")}</Notice>}
      <p>{t("shortcut.hint")}</p>
      <div className="keys-groups">
        {GROUPS.map((group) => (
          <section key={group} aria-label={t(`shortcutGroup.${group}`)}>
            <h3>{t(`shortcutGroup.${group}`)}</h3>
            <dl className="keys-list">
              {SHORTCUTS.filter((shortcut) => shortcut.group === group).map((shortcut) => (
                <Key key={shortcut.key} shortcut={shortcut} />
              ))}
            </dl>
          </section>
        ))}
        <section aria-label={t("shortcutGroup.time")}>
          <h3>{t("shortcutGroup.time")}</h3>
          <dl className="keys-list">
            {TIME_KEYS.map(({ keys, words }) => (
              <div key={words} className="keys-row">
                <dt>
                  {keys.map((key) => (
                    <kbd key={key}>{keyWord(t, key)}</kbd>
                  ))}
                </dt>
                <dd>{t(`timeKey.${words}`)}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </div>
  );
}

const NAMED_KEYS: Readonly<Record<string, "shift" | "space" | "pageUp" | "pageDown" | "home" | "end">> = {
  Shift: "shift",
  Space: "space",
  PgUp: "pageUp",
  PgDn: "pageDown",
  Home: "home",
  End: "end",
};

/** Keys that have a name of their own in a language. */
function keyWord(t: TFunction, key: string): string {
  const name = NAMED_KEYS[key];
  return name === undefined ? key : t(`shortcut.${name}`);
}

function Key({ shortcut }: { shortcut: Shortcut }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { key, isArmed, words, params = {} } = shortcut;
  const isCapital = /^[A-Z]$/.test(key);
  return (
    <div className="keys-row">
      <dt>
        {isCapital && <kbd>{t("shortcut.shift")}</kbd>}
        <kbd>{key.toUpperCase()}</kbd>
        {isArmed && <kbd>{t("shortcut.enter")}</kbd>}
      </dt>
      <dd>{sentence({ level: "info", key: words, params })}</dd>
    </div>
  );
}
