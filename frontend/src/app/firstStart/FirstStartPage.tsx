import { type ReactNode, type RefObject, useEffect, useId, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { InviteForm } from "../../features/access/Invite";
import { useFreshLists } from "../../features/access/useAccessLists";
import { BoardForm } from "../../features/setup/BoardLink";
import "../../features/setup/setup.css";
import { Facts } from "../../features/setup/Facts";
import { SimulatorForm } from "../../features/setup/SimulatorLink";
import { useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { EditScope } from "../../ui/openEdits";
import { LanguageSwitch } from "../bars/Header";
import "./firstStart.css";
import { FIRST_START } from "./firstStart";

const STEPS = ["language", "board", "simulator", "key"] as const;
type Step = (typeof STEPS)[number];

const FORMS: Readonly<Record<Step, () => ReactNode>> = {
  language: LanguageSwitch,
  board: () => (
    <>
      <BoardForm />
      <LinkState link="board" />
    </>
  ),
  simulator: () => (
    <EditScope>
      <SimulatorForm />
      <LinkState link="simulator" />
    </EditScope>
  ),
  key: KeyForm,
};

/** What a new station has to know, one thing after the other. It stands where the tabs do: alarms stay in sight. */
export function FirstStartPage() {
  const { t } = useTranslation();
  const { end } = usePart(FIRST_START);
  const [at, setAt] = useState(0);
  const step = STEPS[at] ?? STEPS[0];
  const isLast = at === STEPS.length - 1;
  const isSkipped = useConnection(
    ({ status }) =>
      (step === "board" || step === "simulator") && (status?.[step].state ?? "closed") === "closed",
  );
  const title = useId();
  const heading = useHeadingOf(at);
  const Form = FORMS[step];
  return (
    <main className="first-start" aria-labelledby={title}>
      <div className="first-start-card">
        <header>
          <h2 id={title}>{t("firstStart.title")}</h2>
          <p>{t("firstStart.text")}</p>
        </header>
        <ol className="first-start-steps" aria-label={t("firstStart.steps")}>
          {STEPS.map((one) => (
            <li key={one} aria-current={one === step ? "step" : undefined}>
              {t(`firstStartStep.${one}`)}
            </li>
          ))}
        </ol>
        <section key={step} className="first-start-step">
          <h3 ref={heading} tabIndex={-1}>
            {t("firstStart.step", {
              number: at + 1,
              count: STEPS.length,
              name: t(`firstStartStep.${step}`),
            })}
          </h3>
          <p>{t(`firstStartHint.${step}`)}</p>
          <Form />
        </section>
        <footer className="first-start-buttons">
          <Button onPress={() => void end()}>{t("firstStart.later")}</Button>
          {at > 0 && <Button onPress={() => setAt(at - 1)}>{t("firstStart.back")}</Button>}
          <Button variant="primary" onPress={() => (isLast ? void end() : setAt(at + 1))}>
            {t(isLast ? "firstStart.done" : isSkipped ? "firstStart.skip" : "firstStart.next")}
          </Button>
        </footer>
      </div>
    </main>
  );
}

/** The heading of a step that was gone to takes the focus, so that it is read out; at first the focus stays where it is. */
function useHeadingOf(at: number): RefObject<HTMLHeadingElement | null> {
  const heading = useRef<HTMLHeadingElement>(null);
  const shown = useRef(at);
  useEffect(() => {
    if (shown.current !== at) {
      shown.current = at;
      heading.current?.focus();
    }
  }, [at]);
  return heading;
}

function LinkState({ link }: { readonly link: "board" | "simulator" }) {
  const { t } = useTranslation();
  const state = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.[link].state ?? "unknown") : "unknown",
  );
  return <Facts facts={[[t("setup.state"), t(`link.${state}`)]]} />;
}

function KeyForm() {
  useFreshLists();
  return <InviteForm />;
}
