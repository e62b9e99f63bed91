import { useTranslation } from "react-i18next";
import "./access.css";

/** How a phone comes to trust this station: take its authority, compare the fingerprint, install it. */
export function TrustSteps() {
  const { t } = useTranslation();
  return (
    <ol className="access-steps">
      <li>
        {t("access.trust1")}{" "}
        <a href="/api/v1/access/authority" download="epf-gcs.crt">
          {t("access.download")}
        </a>
      </li>
      <li>{t("access.trust5")}</li>
      <li>{t("access.trust2")}</li>
      <li>{t("access.trust3")}</li>
      <li>{t("access.trust4")}</li>
    </ol>
  );
}

/** For a stranger whose browser has just warned of the station: not without the screen that shows the fingerprint. */
export function TrustForStrangers() {
  const { t } = useTranslation();
  return (
    <details className="enter-way enter-trust">
      <summary>{t("access.trustWarned")}</summary>
      <p>{t("access.trustWhy")}</p>
      <TrustSteps />
    </details>
  );
}
