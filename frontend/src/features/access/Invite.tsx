import { useState } from "react";
import { useTranslation } from "react-i18next";
import { formatDateTime } from "../../lib/moment";
import type { NewInvitation } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import type { Role } from "../../store/admission";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Select } from "../../ui/Select";
import { CopyLine, QrPicture } from "./Made";
import { RoleSelect, Rows } from "./People";
import { useAccessAdmin, useAccessLists } from "./useAccessLists";

/** How long an invitation may wait for its guest, in minutes: a moment, a lesson, a day. */
const MINUTES = [10, 60, 240, 1440] as const;

/** Makes one-time keys, each with its address and QR code, and lists those that nobody has used yet. */
export function Invite() {
  const { t } = useTranslation();
  const invitations = useAccessLists((lists) => lists.invitations);
  return (
    <div className="access-section">
      <InviteForm />
      <h3>{t("access.openInvitations")}</h3>
      {invitations?.length === 0 && <p>{t("access.noInvitations")}</p>}
      {invitations !== null && invitations.length > 0 && (
        <Rows head={[t("access.role"), t("access.validUntil"), t("access.actions")]}>
          {invitations.map(({ id, role, until_s }) => (
            <tr key={id}>
              <td>{t(`role.${role}`)}</td>
              <td>{formatDateTime(until_s)}</td>
              <td>
                <EndInvitation id={id} />
              </td>
            </tr>
          ))}
        </Rows>
      )}
    </div>
  );
}

/** Role, time and address of an invitation to be made, and the one made last. `tab`: what it opens. */
export function InviteForm({ tab }: { readonly tab?: string }) {
  const { t } = useTranslation();
  const admin = useAccessAdmin();
  const addresses = useAccessLists((lists) => lists.addresses?.addresses) ?? [];
  const made = useAccessLists((lists) => lists.made);
  const [role, setRole] = useState<Role>("viewer");
  const [minutes, setMinutes] = useState<number>(MINUTES[1]);
  const [wanted, setWanted] = useState<string | null>(null);
  const { state, stateText } = useAsked("access.invite");
  const address = addresses.find((one) => one === wanted) ?? addresses[0];

  function invite(): void {
    const wish = {
      role,
      minutes,
      ...(address === undefined ? {} : { address }),
      ...(tab === undefined ? {} : { tab }),
    };
    void admin.invite(wish, { control: "access.invite" });
  }

  return (
    <>
      <p>{t("access.invitationHint")}</p>
      <div className="access-row">
        <RoleSelect label={t("access.role")} value={role} onChange={setRole} />
        <Select
          label={t("access.minutes")}
          options={MINUTES.map((count) => ({
            value: String(count),
            label: t("access.minutesOf", { count }),
          }))}
          value={String(minutes)}
          onChange={(value) => setMinutes(Number(value))}
          placeholder={t("access.minutes")}
        />
        {addresses.length > 1 && address !== undefined && (
          <Select
            label={t("access.address")}
            options={addresses.map((one) => ({ value: one, label: one }))}
            value={address}
            onChange={setWanted}
            placeholder={t("access.address")}
          />
        )}
        <Button variant="primary" onPress={invite} state={state} stateText={stateText}>
          {t("access.makeInvitation")}
        </Button>
      </div>
      {addresses.length === 0 && <Notice level="warning">{t("access.addressesNone")}</Notice>}
      {made !== null && "invitation" in made && <Invitation made={made.invitation} />}
    </>
  );
}

function Invitation({ made: { invitation, key, address, qr_svg } }: { readonly made: NewInvitation }) {
  const { t } = useTranslation();
  const title = t("access.invitationMade", {
    role: t(`role.${invitation.role}`),
    time: formatDateTime(invitation.until_s),
  });
  return (
    <section className="access-made" aria-label={title}>
      {qr_svg !== null && <QrPicture svg={qr_svg} what={t("access.address")} />}
      <div className="access-made-words">
        <h3>{title}</h3>
        <p>{t("access.shownOnce")}</p>
        {qr_svg === null && <p>{t("access.noCode")}</p>}
        <CopyLine label={t("access.address")} text={address} />
        <CopyLine label={t("access.keyAlone")} text={key} />
      </div>
    </section>
  );
}

function EndInvitation({ id }: { readonly id: string }) {
  const { t } = useTranslation();
  const admin = useAccessAdmin();
  const control = `access.invitation.${id}`;
  const { state, stateText } = useAsked(control);
  return (
    <Button onPress={() => void admin.endInvitation(id, { control })} state={state} stateText={stateText}>
      {t("access.endInvitation")}
    </Button>
  );
}
