import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { type Admission, isAtLeast, type Role } from "../store/admission";
import { usePage } from "../store/hooks";

/** One value of who this page's user is for the station. */
export function useAdmission<T>(select: (admission: Admission) => T): T {
  return useStore(usePage().admission, select);
}

/** Why this user's role does not allow it; undefined if it does, or while the role is not known. */
export function useRoleBlocked(least: Role): string | undefined {
  const { t } = useTranslation();
  const role = useAdmission((admission) => admission.role);
  return role === null || isAtLeast(role, least) ? undefined : t(`needs.${least}`);
}
