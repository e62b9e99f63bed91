import { createContext, useContext } from "react";
import type { Page } from "../../store/hooks";

/** The page of the present, for parts of a window that may show the past. */
export const PresentPage = createContext<Page | null>(null);

export function usePresentPage(): Page {
  const present = useContext(PresentPage);
  if (present === null) {
    throw new Error("PresentPage is missing above a part that shows the present");
  }
  return present;
}
