import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { TOUCH_STICK } from "../features/gamepad/touchStick";
import { usePart, useSettings } from "../store/hooks";
import { LoadFailure } from "./dialogs";
import { TOUCH, TUNING } from "./views/views";

/** The tuning view under the tabs, for as long as a loop is chosen. */
export function Tuning() {
  const { t } = useTranslation();
  const isOpen = useSettings(({ choices }) => (choices["tuning.loop"] ?? "") !== "");
  const { Part } = TUNING;
  return isOpen ? (
    <Part waiting={<p className="app-waiting">{t("window.loading")}</p>} failed={NotLoaded} />
  ) : null;
}

/** The stick on the screen, for as long as it is wanted. */
export function ScreenStick() {
  const { t } = useTranslation();
  const isOpen = useStore(usePart(TOUCH_STICK).store, (state) => state.isOpen);
  const { Part } = TOUCH;
  return isOpen ? (
    <Part waiting={<p className="app-waiting">{t("window.loading")}</p>} failed={NotLoaded} />
  ) : null;
}

function NotLoaded(retry: () => void): ReactNode {
  return <LoadFailure onRetry={retry} />;
}
