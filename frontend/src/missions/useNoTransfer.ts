import { useTranslation } from "react-i18next";
import { useConnection } from "../store/hooks";

/** What says why no plan goes to the board or comes from it. */
interface NoTransfer {
  /** For a button; undefined if plans can go. */
  readonly short: string | undefined;
  /** For a notice: only of a board that has said that it cannot. One that is silent may be able to. */
  readonly long: string | undefined;
}

export function useNoTransfer(): NoTransfer {
  const { t } = useTranslation();
  const canTransfer = useConnection(({ status }) => status?.board.features.missions === true);
  const isKnown = useConnection(({ status }) => (status?.board.mode ?? null) !== null);
  if (canTransfer) {
    return { short: undefined, long: undefined };
  }
  return isKnown
    ? { short: t("plans.unsupportedShort"), long: t("plans.unsupported") }
    : { short: t("plans.unknownShort"), long: undefined };
}
