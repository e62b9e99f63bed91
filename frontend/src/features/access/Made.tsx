import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button";
import { copyText } from "../../ui/copyText";
import { Notice } from "../../ui/Notice";

/** A text that is shown once, with a button that copies it. */
export function CopyLine({ label, text }: { readonly label: string; readonly text: string }) {
  const { t } = useTranslation();
  const [outcome, setOutcome] = useState<boolean | null>(null);
  return (
    <div className="access-copy">
      <span className="access-copy-label">{label}</span>
      <code>{text}</code>
      <Button onPress={() => void copyText(text).then(setOutcome)} label={`${t("access.copy")} ${label}`}>
        {t("access.copy")}
      </Button>
      {outcome === true && <span role="status">{t("access.copied")}</span>}
      {outcome === false && <Notice level="warning">{t("access.notCopied")}</Notice>}
    </div>
  );
}

/** The station's own picture of an address. Black on white in every look: a camera reads nothing else. */
export function QrPicture({ svg, what }: { readonly svg: string; readonly what: string }) {
  const { t } = useTranslation();
  return (
    <img
      className="access-qr"
      src={`data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`}
      alt={t("access.qrOf", { what })}
    />
  );
}
