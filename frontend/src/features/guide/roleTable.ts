import { ACCESS_TABLE, type AccessRow, LEAST_ROLES, type LeastRole } from "../../protocol/access.gen";

/** One way in which a subject may be changed: the role that is enough, and whether control is needed as well. */
export interface Change {
  readonly least: LeastRole;
  readonly control: boolean;
}

/** What a role may do with a subject of the interface, read from the table that the station itself holds requests against. */
export interface SubjectRow {
  readonly subject: string;
  /** Null: there is nothing to see. */
  readonly sees: LeastRole | null;
  /** Those that differ, the least role first. */
  readonly changes: readonly Change[];
}

export function subjectRows(table: readonly AccessRow[] = ACCESS_TABLE): readonly SubjectRow[] {
  const subjects = [...new Set(table.map(({ tag }) => tag))].sort();
  return subjects.map((subject) => {
    const rows = table.filter(({ tag }) => tag === subject);
    const seen = rows.filter(({ method, least }) => method === "GET" && least !== "anyone");
    return { subject, sees: [...seen].sort(byRole)[0]?.least ?? null, changes: changesOf(rows) };
  });
}

function changesOf(rows: readonly AccessRow[]): readonly Change[] {
  const changes = rows.filter(({ method }) => method !== "GET").sort(byRole);
  return changes
    .filter(
      (one, index) =>
        changes.findIndex((other) => other.least === one.least && other.control === one.control) === index,
    )
    .map(({ least, control }) => ({ least, control }));
}

function byRole(one: AccessRow, other: AccessRow): number {
  return (
    LEAST_ROLES.indexOf(one.least) - LEAST_ROLES.indexOf(other.least) ||
    Number(one.control) - Number(other.control)
  );
}
