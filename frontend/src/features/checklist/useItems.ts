import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ChecklistLine } from "../../protocol/guards.gen";
import { usePart } from "../../store/hooks";
import { CHECKLIST, OWN_LINES, WATCHED } from "./checklist";

/** A line as it is shown. `id` stays the same in another language. */
export interface Item extends ChecklistLine {
  readonly id: string;
}

/** The lines of the list that holds: the station's, or the page's own in its language. */
export function useItems(): readonly Item[] {
  const { t } = useTranslation();
  const list = useStore(usePart(CHECKLIST).store, (state) => state.list);
  return useMemo((): readonly Item[] => {
    if (list?.isOwn === false) {
      return list.lines.map((line, index) => ({
        ...line,
        id: `${line.text}#${list.lines.slice(0, index).filter(({ text }) => text === line.text).length}`,
      }));
    }
    return [
      ...OWN_LINES.map((own) => ({ id: `own.${own}`, text: t(`checklistLine.${own}`), watched: null })),
      ...WATCHED.map((watched) => ({ id: `own.${watched}`, text: t(`checklistWatch.${watched}`), watched })),
    ];
  }, [list, t]);
}
