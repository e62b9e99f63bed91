import { type ReactNode, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatDateTime } from "../../lib/moment";
import type { PersonState, SessionState } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { ROLES, type Role } from "../../store/admission";
import { Button } from "../../ui/Button";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import type { PersonChange } from "./accessAdmin";
import { useAccessAdmin, useAccessLists } from "./useAccessLists";

/** Who waits to be let in, and everybody who came in: role, name, when last seen, where from, and their end. */
export function People() {
  const { t } = useTranslation();
  const people = useAccessLists((lists) => lists.people);
  const waiting = people?.filter(({ state }) => state === "waiting") ?? [];
  const others = people?.filter(({ state }) => state !== "waiting") ?? [];
  return (
    <div className="access-section">
      {waiting.length > 0 && (
        <section aria-label={t("access.waitingPeople")} className="access-waiting">
          <h3>{t("access.waitingPeople")}</h3>
          {waiting.map((person) => (
            <Waiting key={person.id} person={person} />
          ))}
        </section>
      )}
      {people !== null && others.length === 0 && <p>{t("access.nobody")}</p>}
      {others.length > 0 && (
        <Rows
          head={[
            t("access.person"),
            t("access.role"),
            t("access.lastSeen"),
            t("access.from"),
            t("access.actions"),
          ]}
        >
          {others.map((person) => (
            <PersonRow key={person.id} person={person} />
          ))}
        </Rows>
      )}
      <SessionRows />
    </div>
  );
}

/** A table that can be read on a narrow screen: there each row is a card, and what is wider yet scrolls by itself. */
export function Rows({ head, children }: { readonly head: readonly string[]; readonly children: ReactNode }) {
  return (
    <div className="access-scroll">
      <table className="access-table">
        <thead>
          <tr>
            {head.map((cell) => (
              <th key={cell} scope="col">
                {cell}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>{children}</tbody>
      </table>
    </div>
  );
}

/** The choice of a role. */
export function RoleSelect(props: {
  readonly label: string;
  readonly value: Role;
  readonly onChange: (role: Role) => void;
  readonly hideLabel?: boolean;
  readonly disabledReason?: string | undefined;
}) {
  const { t } = useTranslation();
  return (
    <Select
      {...props}
      options={ROLES.map((role) => ({ value: role, label: t(`role.${role}`) }))}
      placeholder={props.label}
    />
  );
}

function usePersonChange(person: PersonState) {
  const admin = useAccessAdmin();
  const control = `access.person.${person.id}`;
  const { state, stateText } = useAsked(control);
  return {
    outcome: state === "rejected" ? { state, stateText } : {},
    change: (wish: PersonChange) => void admin.changePerson(person.id, wish, { control }),
    forget: () => void admin.forgetPerson(person.id, { control }),
  };
}

function called({ name, place }: PersonState): string {
  return place === "" ? name : `${name} · ${place}`;
}

function Waiting({ person }: { readonly person: PersonState }) {
  const { t } = useTranslation();
  const { outcome, change, forget } = usePersonChange(person);
  const [role, setRole] = useState<Role>("viewer");
  return (
    <div className="access-row">
      <p className="access-asking">
        <strong>{called(person)}</strong> <span>{person.address}</span>
      </p>
      <RoleSelect
        label={t("access.letInAs", { name: person.name })}
        hideLabel
        value={role}
        onChange={setRole}
      />
      <Button variant="primary" onPress={() => change({ state: "in", role })} {...outcome}>
        {t("access.letIn")}
      </Button>
      <Button onPress={forget}>{t("access.refuse")}</Button>
    </div>
  );
}

function PersonRow({ person }: { readonly person: PersonState }) {
  const { t } = useTranslation();
  const { outcome, change, forget } = usePersonChange(person);
  const [isEnding, setEnding] = useState(false);
  const name = called(person);
  const isIn = person.state === "in";
  return (
    <tr data-state={person.state}>
      <td>
        <TextField
          label={t("access.nameOf", { name })}
          hideLabel
          value={person.name}
          onCommit={(text) => change({ name: text.trim() })}
        />
        {person.place !== "" && <span className="access-place">{person.place}</span>}
      </td>
      <td>
        {isIn ? (
          <RoleSelect
            label={t("access.roleOf", { name })}
            hideLabel
            value={person.role}
            onChange={(role) => change({ role })}
          />
        ) : (
          t("access.stateEnded")
        )}
      </td>
      <td>{formatDateTime(person.seen_s)}</td>
      <td>{person.address}</td>
      <td>
        <div className="access-buttons">
          {isIn ? (
            <Button
              variant="danger"
              label={t("access.endOne", { name })}
              onPress={() => setEnding(true)}
              {...outcome}
            >
              {t("access.end")}
            </Button>
          ) : (
            <Button label={t("access.forgetOne", { name })} onPress={forget} {...outcome}>
              {t("access.forget")}
            </Button>
          )}
        </div>
        {isEnding && (
          <EndDialog
            title={t("access.endTitle", { name })}
            text={t("access.endText")}
            onEnd={() => change({ state: "ended" })}
            onClose={() => setEnding(false)}
          />
        )}
      </td>
    </tr>
  );
}

/** The question before somebody is put out. */
export function EndDialog(props: {
  readonly title: string;
  readonly text: string;
  readonly onEnd: () => void;
  readonly onClose: () => void;
}) {
  const { t } = useTranslation();
  return (
    <ConfirmDialog
      title={props.title}
      text={props.text}
      confirmLabel={t("access.end")}
      cancelLabel={t("control.takeCancel")}
      danger
      onConfirm={() => {
        props.onClose();
        props.onEnd();
      }}
      onCancel={props.onClose}
    />
  );
}

/** Each browser that is in: one person may have several. */
function SessionRows() {
  const { t } = useTranslation();
  const sessions = useAccessLists((lists) => lists.sessions);
  if (sessions.length === 0) {
    return null;
  }
  return (
    <section aria-label={t("access.pages")} className="access-section">
      <h3>{t("access.pages")}</h3>
      <Rows head={[t("access.person"), t("access.lastSeen"), t("access.from"), t("access.actions")]}>
        {sessions.map((session) => (
          <SessionRow key={session.id} session={session} />
        ))}
      </Rows>
    </section>
  );
}

function SessionRow({ session: { id, name, seen_s, address } }: { readonly session: SessionState }) {
  const { t } = useTranslation();
  const admin = useAccessAdmin();
  const [isEnding, setEnding] = useState(false);
  return (
    <tr>
      <td>{name}</td>
      <td>{formatDateTime(seen_s)}</td>
      <td>{address}</td>
      <td>
        <Button
          variant="danger"
          label={t("access.endSession", { name, address })}
          onPress={() => setEnding(true)}
        >
          {t("access.end")}
        </Button>
        {isEnding && (
          <EndDialog
            title={t("access.endSessionTitle", { name })}
            text={t("access.endSessionText", { address })}
            onEnd={() => void admin.endSession(id, { control: `access.session.${id}` })}
            onClose={() => setEnding(false)}
          />
        )}
      </td>
    </tr>
  );
}
