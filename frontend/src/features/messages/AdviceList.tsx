import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import type { Advice } from "../../protocol/inspector";
import { adviceMessage } from "../../store/advice";
import { useIsPast } from "../../store/hooks";
import { Notice } from "../../ui/Notice";

/** From this many of one kind on, one sentence for all: ten slow streams have one cause. */
const TOGETHER = 3;

/** Advice on every problem, or a sentence that all is well. */
export function AdviceList({ advice }: { advice: readonly Advice[] }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const isPast = useIsPast();
  const slow = advice.filter(({ code }) => code === "stream_slow");
  const shown = slow.length < TOGETHER ? advice : advice.filter(({ code }) => code !== "stream_slow");
  const list = slow
    .map(({ params }) => `${params["topic"]} ${params["rate_hz"]}/${params["expected_hz"]} Hz`)
    .join(", ");
  return (
    <section className="messages-advice" aria-label={t("messages.advice")}>
      {advice.length === 0 && (
        <p className="messages-well">{t(isPast ? "messages.pastAdvice" : "messages.allWell")}</p>
      )}
      {shown.map((one) => (
        <Notice key={sentence(adviceMessage(one.code, one))} level={one.level}>
          {sentence(adviceMessage(one.code, one))}
        </Notice>
      ))}
      {slow.length >= TOGETHER && (
        <Notice level="info">{t("advice.streams_slow", { number: slow.length, list })}</Notice>
      )}
    </section>
  );
}
