import type { TFunction } from "i18next";
import { useTranslation } from "react-i18next";
import type { LeastRole } from "../../protocol/access.gen";
import { subjectRows } from "./roleTable";

/** What each role may do, as the station itself has it. */
export function RoleTable() {
  const { t } = useTranslation();
  return (
    <table>
      <thead>
        <tr>
          <th scope="col">{t("roleTable.what")}</th>
          <th scope="col">{t("roleTable.sees")}</th>
          <th scope="col">{t("roleTable.changes")}</th>
        </tr>
      </thead>
      <tbody>
        {subjectRows().map(({ subject, sees, changes }) => (
          <tr key={subject}>
            <td>{subjectWord(t, subject)}</td>
            <td>{sees === null ? t("roleTable.nobody") : roleWord(t, sees)}</td>
            <td>
              {changes.length === 0
                ? t("roleTable.nobody")
                : changes
                    .map(({ least, control }) => {
                      const role = roleWord(t, least);
                      return control ? t("roleTable.withControl", { role }) : role;
                    })
                    .join("; ")}
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function roleWord(t: TFunction, role: LeastRole): string {
  return role === "anyone" ? t("roleTable.anyone") : t(`role.${role}`);
}

/** A subject that is newer than the catalogues keeps the interface's own name; a test finds it. */
function subjectWord(t: TFunction, subject: string): string {
  return (t as unknown as (key: string, options: object) => string)(`roleSubject.${subject}`, {
    defaultValue: subject,
  });
}
