import { useSettings } from "../store/hooks";
import { TABS, type TabName } from "./views";

/** The main tab that is open: the one last chosen. */
export function useOpenTab(): TabName {
  return useSettings(({ choices }) => TABS.find((tab) => tab === choices["tab"]) ?? "flight");
}
