import { createContext, type ReactNode, use, useState } from "react";
import { useTranslation } from "react-i18next";
import { Dialog } from "../../ui/Dialog";
import type { FigureName } from "./figures";

const Asked = createContext<(name: FigureName) => void>(() => undefined);

/** Shows the definition, as the guide has it, of the figure whose name was pressed. */
export function Definitions({ children }: { readonly children: ReactNode }) {
  const { t } = useTranslation();
  const [name, setName] = useState<FigureName | null>(null);
  const words = name === null ? "" : t(`report.figures.${name}`);
  return (
    <Asked value={setName}>
      {children}
      {name !== null && (
        <Dialog title={words} onClose={() => setName(null)}>
          <p>{name === null ? "" : t(`report.definitions.${name}`)}</p>
          <p className="report-quiet">{t("report.inGuide")}</p>
        </Dialog>
      )}
    </Asked>
  );
}

/** The name of a figure; pressing it says what it means. */
export function FigureLabel({ name }: { readonly name: FigureName }) {
  const { t } = useTranslation();
  const words = t(`report.figures.${name}`);
  const ask = use(Asked);
  return (
    <button
      type="button"
      className="report-define"
      aria-label={t("report.define", { name: words })}
      onClick={() => ask(name)}
    >
      {words}
    </button>
  );
}
