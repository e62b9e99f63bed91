import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { formatDateTime } from "../../lib/moment";
import type { Flight } from "../../protocol/guards.gen";
import { otherHolder, pageName } from "../../requests/useControl";
import { useRoleBlocked } from "../../requests/useRole";
import type { Role } from "../../store/admission";
import type { Connection } from "../../store/connection";
import { usePart } from "../../store/hooks";
import { FLIGHTS, type LibraryState } from "./flightLibrary";

/** One value of the library; the component renders again when it changes. */
export function useLibrary<T>(select: (state: LibraryState) => T): T {
  return useStore(usePart(FLIGHTS).store, select);
}

/** One value of the present's connection, whatever the page shows. */
export function usePresent<T>(select: (connection: Connection) => T): T {
  return useStore(usePart(FLIGHTS).connection, select);
}

/** Why this user cannot ask the library anything now, or nothing that needs this role; undefined if it can. */
export function useLibraryUnreachable(least: Role = "viewer"): string | undefined {
  const { t } = useTranslation();
  const role = useRoleBlocked(least);
  return usePresent(({ phase }) => phase === "open") ? role : t("blocked.gateway");
}

/** Why flights cannot be deleted or brought in from here now; undefined if they can. Looking at the past forbids neither. */
export function useLibraryBlocked(least: Role): string | undefined {
  const { t } = useTranslation();
  const holder = usePresent((connection) => {
    const other = otherHolder(connection);
    return other === null ? null : pageName(t, other);
  });
  const unreachable = useLibraryUnreachable(least);
  return unreachable ?? (holder === null ? undefined : t("blocked.viewer", { name: holder }));
}

/** What a flight is called: its title, else when it began. */
export function flightName({ title, started_s }: Pick<Flight, "title" | "started_s">): string {
  return title === "" ? formatDateTime(started_s) : title;
}
