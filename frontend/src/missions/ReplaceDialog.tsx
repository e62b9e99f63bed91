import { useTranslation } from "react-i18next";
import { ConfirmDialog } from "../ui/ConfirmDialog";

interface Props {
  readonly onConfirm: () => void;
  /** It was answered, either way. */
  readonly onClose: () => void;
}

/** Asks before a plan that was edited and not sent is replaced. */
export function ReplaceDialog({ onConfirm, onClose }: Props) {
  const { t } = useTranslation();
  return (
    <ConfirmDialog
      title={t("plans.replaceTitle")}
      text={t("plans.replaceText")}
      confirmLabel={t("plans.replace")}
      cancelLabel={t("plans.keep")}
      onConfirm={() => {
        onClose();
        onConfirm();
      }}
      onCancel={onClose}
    />
  );
}
