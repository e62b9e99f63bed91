import type { TFunction } from "i18next";
import { useCallback } from "react";
import { useTranslation } from "react-i18next";
import type { Message } from "../store/messages";

/** A key that is only known at run time: a problem's code, a command's name. */
type LooseT = (key: string, params: Readonly<Record<string, unknown>>) => string;

/**
 * Message -> sentence in the page's language. For a problem code without a translation, the gateway's own English
 * text.
 */
export function useSentence(): (message: Message) => string {
  const { t, i18n } = useTranslation();
  return useCallback(
    ({ key, params, fallback }) => {
      if (!i18n.exists(key)) {
        return fallback ?? key;
      }
      const words = Object.fromEntries(
        Object.entries(params).map(([name, value]) => [name, nameOf(t, i18n.exists, value)]),
      );
      return (t as unknown as LooseT)(key, words);
    },
    [t, i18n],
  );
}

/** A parameter that is itself the name of something in the catalogue ("@command.autopilot_on") is translated too. */
function nameOf(t: TFunction, exists: (key: string) => boolean, value: string | number): string | number {
  if (typeof value !== "string" || !value.startsWith("@")) {
    return value;
  }
  const key = value.slice(1);
  return exists(key) ? (t as unknown as LooseT)(key, {}) : key.slice(key.indexOf(".") + 1);
}
