import "./six.css";
import type { ParseKeys } from "i18next";
import { type ReactNode, useCallback } from "react";
import { useTranslation } from "react-i18next";
import type { TopicName } from "../../protocol/topics";
import { StreamPanel } from "../../readouts/StreamPanel";
import { ReadoutGrid } from "../../ui/Readout";

/** The six instruments, as large as the tab allows. */
export function SixGrid({ children }: { children: ReactNode }) {
  return (
    <div className="six">
      <div className="six-grid">{children}</div>
    </div>
  );
}

interface Props {
  topic: TopicName;
  title: string;
  dial: ReactNode;
  /** Where its value comes from, with the number and its unit. */
  children: ReactNode;
}

/** One instrument with its stream's state over it and its source under it. */
export function SixCell({ topic, title, dial, children }: Props) {
  return (
    <StreamPanel topic={topic} title={title} className="six-cell" narrow plain>
      <div className="six-dial">{dial}</div>
      <ReadoutGrid className="six-source">{children}</ReadoutGrid>
    </StreamPanel>
  );
}

/** Name of a value with the group in which the other tabs show it: "Analog · Speed". */
export function useSource(): (group: ParseKeys, name: ParseKeys) => string {
  const { t } = useTranslation();
  return useCallback((group, name) => t("six.source", { group: t(group), name: t(name) }), [t]);
}
