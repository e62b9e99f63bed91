import { useTranslation } from "react-i18next";
import { Button } from "../../../ui/Button";
import { Notice } from "../../../ui/Notice";
import type { GlobeProblem } from "./useKeptGlobe";

/** Says over the flat map why it replaces the globe. */
export function GlobeMissing({ problem, onRetry }: { problem: GlobeProblem; onRetry: () => void }) {
  const { t } = useTranslation();
  const reason = {
    notLoaded: t("map.view.notLoaded"),
    noWebgl: t("map.view.noWebgl"),
    lost: t("map.view.lost"),
  }[problem];
  return (
    <div className="map-missing">
      <Notice level="warning">
        <p>
          {reason} {t("map.flat.instead")}
        </p>
      </Notice>
      <Button onPress={onRetry}>{t("map.view.again")}</Button>
    </div>
  );
}
