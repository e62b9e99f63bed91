import { useState } from "react";
import { useTranslation } from "react-i18next";
import { formatDateTime } from "../../lib/moment";
import type { ProgramState } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import type { Role } from "../../store/admission";
import { Button } from "../../ui/Button";
import { TextField } from "../../ui/TextField";
import { CopyLine } from "./Made";
import { EndDialog, RoleSelect, Rows } from "./People";
import { useAccessAdmin, useAccessLists } from "./useAccessLists";

/** Keys of programs: made here, shown once, listed with their last use, and ended. */
export function Programs() {
  const { t } = useTranslation();
  const programs = useAccessLists((lists) => lists.programs);
  const made = useAccessLists((lists) => lists.made);
  return (
    <div className="access-section">
      <p>{t("access.programsHint")}</p>
      <NewProgramForm />
      {made !== null && "program" in made && (
        <section
          className="access-made"
          aria-label={t("access.programMade", { name: made.program.program.name })}
        >
          <div className="access-made-words">
            <h3>{t("access.programMade", { name: made.program.program.name })}</h3>
            <p>{t("access.shownOnce")}</p>
            <CopyLine label={t("access.keyAlone")} text={made.program.key} />
          </div>
        </section>
      )}
      {programs?.length === 0 && <p>{t("access.noPrograms")}</p>}
      {programs !== null && programs.length > 0 && (
        <Rows head={[t("access.programName"), t("access.role"), t("access.lastSeen"), t("access.actions")]}>
          {programs.map((program) => (
            <ProgramRow key={program.id} program={program} />
          ))}
        </Rows>
      )}
    </div>
  );
}

function NewProgramForm() {
  const { t } = useTranslation();
  const admin = useAccessAdmin();
  const [name, setName] = useState("");
  const [role, setRole] = useState<Role>("viewer");
  const { state, stateText } = useAsked("access.program");
  return (
    <div className="access-row">
      <TextField label={t("access.programName")} value={name} onEdit={setName} onCommit={setName} />
      <RoleSelect label={t("access.role")} value={role} onChange={setRole} />
      <Button
        variant="primary"
        onPress={() => void admin.makeProgram(name.trim(), role, { control: "access.program" })}
        state={state}
        stateText={stateText}
        disabledReason={name.trim() === "" ? t("access.programNameFirst") : undefined}
      >
        {t("access.makeProgram")}
      </Button>
    </div>
  );
}

function ProgramRow({ program: { id, name, role, seen_s } }: { readonly program: ProgramState }) {
  const { t } = useTranslation();
  const admin = useAccessAdmin();
  const [isEnding, setEnding] = useState(false);
  return (
    <tr>
      <td>{name}</td>
      <td>{t(`role.${role}`)}</td>
      <td>{seen_s === null ? t("access.never") : formatDateTime(seen_s)}</td>
      <td>
        <Button variant="danger" label={t("access.endOne", { name })} onPress={() => setEnding(true)}>
          {t("access.end")}
        </Button>
        {isEnding && (
          <EndDialog
            title={t("access.endTitle", { name })}
            text={t("access.endProgramText")}
            onEnd={() => void admin.endProgram(id, { control: `access.program.${id}` })}
            onClose={() => setEnding(false)}
          />
        )}
      </td>
    </tr>
  );
}
