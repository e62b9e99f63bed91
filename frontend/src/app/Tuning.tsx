import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useSettings } from "../store/hooks";
import { LoadFailure } from "./dialogs/dialogs";
import { TUNING } from "./views";

/** The tuning view under the tabs, for as long as a loop is chosen. */
export function Tuning() {
  const { t } = useTranslation();
  const isOpen = useSettings(({ choices }) => (choices["tuning.loop"] ?? "") !== "");
  const { Part } = TUNING;
  return isOpen ? (
    <Part waiting={<p className="app-waiting">{t("window.loading")}</p>} failed={NotLoaded} />
  ) : null;
}

function NotLoaded(retry: () => void): ReactNode {
  return <LoadFailure onRetry={retry} />;
}
