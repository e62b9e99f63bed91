import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatDateTime } from "../../lib/moment";
import { failureMessage } from "../../store/messages";
import { Notice } from "../../ui/Notice";
import { AddressCode, CopyLine, Unfolding } from "./Made";
import { TrustSteps } from "./Trust";
import { useAccessLists } from "./useAccessLists";

/** Where others reach this station, its certificate, and how a phone comes to trust it. */
export function StationAddresses() {
  const { t } = useTranslation();
  const addresses = useAccessLists((lists) => lists.addresses);
  return (
    <div className="access-section">
      {addresses !== null &&
        (addresses.addresses.length === 0 ? (
          <Notice level="info">{t("access.addressesNone")}</Notice>
        ) : (
          <>
            <p>{t("access.addressesHint")}</p>
            {addresses.addresses.map((address) => (
              <CopyLine key={address} label={t("access.address")} text={address}>
                <Unfolding label={t("access.code")} name={t("access.qrOf", { what: address })}>
                  <AddressCode address={address} what={address} />
                </Unfolding>
              </CopyLine>
            ))}
            {!addresses.tls && <Notice level="warning">{t("access.insecure")}</Notice>}
          </>
        ))}
      <Certificate />
    </div>
  );
}

function Certificate() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const certificates = useAccessLists((lists) => lists.certificates);
  const first = useAccessLists((lists) => lists.addresses?.addresses[0]);
  if (certificates === null) {
    return null;
  }
  const { certificate, authority, fault } = certificates;
  if (certificate === null) {
    return <p>{t("access.noTls")}</p>;
  }
  return (
    <>
      {fault !== null && <Notice level="warning">{sentence(failureMessage(fault))}</Notice>}
      <dl className="access-facts">
        <dt>{t("access.names")}</dt>
        <dd>{[...certificate.names, ...certificate.addresses].join(", ")}</dd>
        <dt>{t("access.validUntil")}</dt>
        <dd>{formatDateTime(certificate.until_s)}</dd>
      </dl>
      {authority !== null && (
        <section className="access-section" aria-label={t("access.trustTitle")}>
          <h3>{t("access.trustTitle")}</h3>
          <TrustSteps />
          <CopyLine label={t("access.fingerprint")} text={authority.fingerprint} />
          {first !== undefined && (
            <div className="access-copy">
              <Unfolding label={t("access.codeOfCertificate")}>
                <AddressCode address={first} to="authority" what={t("access.download")} />
              </Unfolding>
            </div>
          )}
        </section>
      )}
    </>
  );
}
