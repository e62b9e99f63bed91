import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { usePage } from "../../store/hooks";
import { MessageLine } from "../../ui/MessageLine";
import { useDialogs } from "../views/useDialogs";

/** The newest message, with its time, and the way to all of them. */
export function LastMessage() {
  const { t } = useTranslation();
  const { messages } = usePage();
  const sentence = useSentence();
  const language = usePage().settings.getState().language;
  const { open } = useDialogs();
  const last = useStore(messages, (state) => state.last);
  return (
    <MessageLine
      action={{ label: t("status.openLog"), onPress: () => open("log") }}
      label={t("status.message")}
      text={last === null ? t("status.noMessage") : sentence(last)}
      level={last?.level}
      time={
        last === null ? undefined : new Date(last.said_ms).toLocaleTimeString(language, { hour12: false })
      }
    />
  );
}
