import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { usePage, useSettings } from "../../store/hooks";
import { areKeysOn } from "../settings/choices";
import { useDialogs } from "../views/useDialogs";
import { nextStep } from "./keys";
import type { Shortcut } from "./table";
import "./shortcuts.css";

/** An armed key that is not confirmed within this time is disarmed. */
const ARMED_MS = 5000;

/** Runs the page's shortcuts, and asks for a second key where a slip must not switch anything. */
export function Shortcuts() {
  const { t } = useTranslation();
  const page = usePage();
  const { open } = useDialogs();
  const sentence = useSentence();
  const isOn = useSettings(areKeysOn);
  const [armed, setArmed] = useState<Shortcut | null>(null);

  useEffect(() => {
    if (!isOn) {
      setArmed(null);
      return;
    }
    function press(event: KeyboardEvent): void {
      const step = nextStep(event, armed);
      if (step === null) {
        return;
      }
      const wanted = step.run ?? step.armed;
      if (page.past !== null && wanted?.group === "flight") {
        // Nothing is armed either: Enter would come when the present is back.
        setArmed(null);
        page.messages.say({ level: "warning", key: "blocked.past", params: {} });
      } else {
        setArmed(step.armed);
        step.run?.run({ page, open });
      }
      // Enter must not also press the button that has the focus.
      event.preventDefault();
      event.stopPropagation();
    }
    window.addEventListener("keydown", press, { capture: true });
    return () => window.removeEventListener("keydown", press, { capture: true });
  }, [armed, isOn, open, page]);

  // A key that was armed in the present must not wait for its Enter in the past, nor the other way round.
  // biome-ignore lint/correctness/useExhaustiveDependencies: each vehicle that is shown
  useEffect(() => () => setArmed(null), [page]);

  useEffect(() => {
    if (armed === null) {
      return;
    }
    const timer = window.setTimeout(() => setArmed(null), ARMED_MS);
    return () => window.clearTimeout(timer);
  }, [armed]);

  return (
    <div className="app-armed" role="status">
      {armed !== null && (
        <p>
          <strong>{sentence({ level: "info", key: armed.words, params: armed.params ?? {} })}</strong>
          <span>{t("shortcut.confirm")}</span>
        </p>
      )}
    </div>
  );
}
