import { createI18n } from "../../i18n/i18n";
import { LANGUAGES, type Language } from "../../store/settings";
import en from "./alarms.en.json";
import es from "./alarms.es.json";
import type { Speech } from "./annunciator";
import type { AlarmLevel } from "./raisedAlarms";

type LooseT = (key: string, params: Readonly<Record<string, unknown>>) => string;

const VOICE = createI18n({ es, en }, LANGUAGES[0]);

/** The spoken phrase of an alarm: short, to be understood at once. */
export function spokenPhrase({ kind, id, level, others }: Speech, language: Language): string {
  const t = VOICE.getFixedT(language) as unknown as LooseT;
  const name = VOICE.exists(`alarmName.${id}`, { lng: language })
    ? t(`alarmName.${id}`, {})
    : t("alarmVoice.unnamed", {});
  const what =
    kind === "recovered"
      ? t("alarmVoice.recovered", { name })
      : t(level === "critical" ? "alarmVoice.critical" : "alarmVoice.warning", { name });
  return others === 0 ? what : `${what} ${t("alarmVoice.others", { count: others })}`;
}

/** Says that it is a test, so that nobody takes it for an alarm. */
export function testPhrase(level: AlarmLevel, language: Language): string {
  const t = VOICE.getFixedT(language) as unknown as LooseT;
  return t(level === "critical" ? "alarmVoice.testCritical" : "alarmVoice.testWarning", {});
}
