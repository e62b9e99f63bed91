import { type ReactNode, useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { useAdmission } from "../../requests/useRole";
import { useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { Tabs } from "../../ui/Tabs";
import { AccessLog } from "./AccessLog";
import "./access.css";
import { BackupSection } from "./BackupSection";
import { ENTRY } from "./entry";
import { HandOver } from "./HandOver";
import { Invite } from "./Invite";
import { People } from "./People";
import { Programs } from "./Programs";
import { StationAddresses } from "./StationAddresses";
import { useAccessLists, useFreshLists } from "./useAccessLists";

/** "Setup › Acceso": who one is here; for owners who may come in, keys, addresses, and what people did. */
export function AccessPanel() {
  const { t } = useTranslation();
  const isOpen = useConnection(({ phase }) => phase === "open");
  const isOwner = useAdmission(({ role }) => role === "owner");
  return (
    <Panel title={t("access.panel")} className="access">
      <Me />
      <HandOver />
      {isOpen && isOwner && <ForOwners />}
    </Panel>
  );
}

function Me() {
  const { t } = useTranslation();
  const entry = usePart(ENTRY);
  const { kind, role, name } = useAdmission((admission) => admission);
  const [isLeaving, setLeaving] = useState(false);
  if (role === null) {
    return <p>{t("blocked.gateway")}</p>;
  }
  const sentences = { local: "youLocal", anyone: "youAnyone", person: "youAre", program: "youAre" } as const;
  const sentence = t(`access.${sentences[kind ?? "person"]}`, { name: name ?? "", role: t(`role.${role}`) });
  return (
    <section className="access-me" aria-label={t("access.me")}>
      <p>{sentence}</p>
      {kind === "person" && <Button onPress={() => setLeaving(true)}>{t("access.leave")}</Button>}
      {isLeaving && (
        <ConfirmDialog
          title={t("access.leaveTitle")}
          text={t("access.leaveText")}
          confirmLabel={t("access.leave")}
          cancelLabel={t("control.takeCancel")}
          onConfirm={() => {
            setLeaving(false);
            void entry.leave();
          }}
          onCancel={() => setLeaving(false)}
        />
      )}
    </section>
  );
}

function ForOwners() {
  const { t } = useTranslation();
  const sentence = useSentence();
  useFreshLists();
  const failure = useAccessLists((lists) => lists.failure);
  const waiting = useAccessLists(
    ({ people }) => people?.filter(({ state }) => state === "waiting").length ?? 0,
  );
  const sections: ReadonlyArray<readonly [string, string, ReactNode]> = [
    [
      "people",
      waiting === 0 ? t("access.people") : t("access.peopleWaiting", { count: waiting }),
      <People key="p" />,
    ],
    ["invite", t("access.invite"), <Invite key="i" />],
    ["programs", t("access.programs"), <Programs key="g" />],
    ["station", t("access.station"), <StationAddresses key="s" />],
    ["backup", t("backup.section"), <BackupSection key="b" />],
    ["log", t("access.log"), <AccessLog key="l" />],
  ];
  return (
    <>
      {failure !== null && <Notice level="error">{sentence(failure)}</Notice>}
      <Tabs
        label={t("access.sections")}
        tabs={sections.map(([value, label, content]) => ({ value, label, content }))}
      />
    </>
  );
}
