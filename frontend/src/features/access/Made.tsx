import { type ReactNode, useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button";
import { copyText } from "../../ui/copyText";
import { Notice } from "../../ui/Notice";

/** A text that is shown once, with a button that copies it. */
export function CopyLine(props: {
  readonly label: string;
  readonly text: string;
  readonly children?: ReactNode;
}) {
  const { label, text, children } = props;
  const { t } = useTranslation();
  const [outcome, setOutcome] = useState<boolean | null>(null);
  return (
    <div className="access-copy">
      <span className="access-copy-label">{label}</span>
      <code>{text}</code>
      <Button onPress={() => void copyText(text).then(setOutcome)} label={`${t("access.copy")} ${label}`}>
        {t("access.copy")}
      </Button>
      {children}
      {outcome === true && <span role="status">{t("access.copied")}</span>}
      {outcome === false && <Notice level="warning">{t("access.notCopied")}</Notice>}
    </div>
  );
}

/** The station's own picture of an address. Black on white in every look: a camera reads nothing else. */
export function QrPicture({ svg, what }: { readonly svg: string; readonly what: string }) {
  return <Code source={`data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`} what={what} />;
}

/** The same of an address without a key in it, which the station draws when it is asked. */
export function AddressCode(props: {
  readonly address: string;
  readonly to?: "page" | "authority";
  readonly tab?: string;
  readonly what: string;
}) {
  const { address, to = "page", tab, what } = props;
  const query = new URLSearchParams({ address, to, ...(tab === undefined ? {} : { tab }) });
  return <Code source={`/api/v1/access/code?${query}`} what={what} />;
}

/** A picture that is shown when it is asked for. */
export function Unfolding(props: {
  readonly label: string;
  /** Its accessible name, where several stand below each other. */
  readonly name?: string;
  readonly children: ReactNode;
}) {
  const { label, name, children } = props;
  const [isOpen, setOpen] = useState(false);
  return (
    <>
      <Button onPress={() => setOpen(!isOpen)} pressed={isOpen} label={name}>
        {label}
      </Button>
      {isOpen && children}
    </>
  );
}

function Code({ source, what }: { readonly source: string; readonly what: string }) {
  const { t } = useTranslation();
  return <img className="access-qr" src={source} alt={t("access.qrOf", { what })} />;
}
