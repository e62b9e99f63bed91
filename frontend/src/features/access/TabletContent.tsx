import { useTranslation } from "react-i18next";
import { useAdmission } from "../../requests/useRole";
import { useSettings } from "../../store/hooks";
import "./access.css";
import { InviteForm } from "./Invite";
import { addressOf, isOfThisComputerAlone } from "./keyAddress";
import { AddressCode, CopyLine } from "./Made";
import { useAccessAdmin, useFreshLists } from "./useAccessLists";

/** "Open this tab on a tablet": an owner's invitation with its QR code, or the plain address of this tab. */
export function TabletContent() {
  const isOwner = useAdmission(({ role }) => role === "owner");
  // The interface's own name of the tab, in small letters as an address has it.
  const tab = useSettings(({ choices }) => choices["tab"] ?? "fly").toLowerCase();
  return <div className="access-section">{isOwner ? <ForOwner tab={tab} /> : <Plain tab={tab} />}</div>;
}

function ForOwner({ tab }: { readonly tab: string }) {
  const { t } = useTranslation();
  useFreshLists();
  return (
    <>
      <p>{t("access.tabletHint")}</p>
      <InviteForm tab={tab} />
    </>
  );
}

function Plain({ tab }: { readonly tab: string }) {
  const { t } = useTranslation();
  const { address } = useAccessAdmin();
  const text = addressOf(address(), tab);
  if (isOfThisComputerAlone(text)) {
    return <p>{t("access.tabletHere")}</p>;
  }
  return (
    <>
      <p>{t("access.tabletPlain")}</p>
      <AddressCode address={new URL(text).origin} tab={tab} what={text} />
      <CopyLine label={t("access.address")} text={text} />
    </>
  );
}
