import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import type { Advice } from "../../protocol/contract";
import { adviceMessage } from "../../store/advice";
import { useIsPast } from "../../store/hooks";
import { Notice } from "../../ui/Notice";

/** Advice on every problem, or a sentence that all is well. */
export function AdviceList({ advice }: { advice: readonly Advice[] }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const isPast = useIsPast();
  return (
    <section className="messages-advice" aria-label={t("messages.advice")}>
      {advice.length === 0 && (
        <p className="messages-well">{t(isPast ? "messages.pastAdvice" : "messages.allWell")}</p>
      )}
      {advice.map((one) => (
        <Notice key={keyOf(one)} level={one.level}>
          {sentence(adviceMessage(one.code, one))}
        </Notice>
      ))}
    </section>
  );
}

/** What it is about, not its figures: those change while it stands. */
function keyOf({ code, params }: Advice): string {
  return `${code} ${params["topic"] ?? params["row"] ?? params["direction"] ?? ""}`;
}
