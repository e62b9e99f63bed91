import { ChevronDown, ChevronRight } from "lucide-react";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../../../store/hooks";
import { choose } from "../../../store/settings";
import { Button } from "../../../ui/Button";
import { Panel } from "../../../ui/Panel";

interface Props {
  /** Under which the browser remembers whether it is folded. */
  name: string;
  title: string;
  /** Folded until somebody opens it. */
  isFoldedFirst?: boolean;
  className?: string;
  children: ReactNode;
}

/** A panel beside the map that folds to its title. What it draws on the map stays while it is folded. */
export function FoldingPanel({ name, title, isFoldedFirst = false, className, children }: Props) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const key = `map.fold.${name}`;
  const isFolded = useSettings(({ choices }) => (choices[key] ?? (isFoldedFirst ? "yes" : "no")) === "yes");
  const Icon = isFolded ? ChevronRight : ChevronDown;
  return (
    <Panel
      title={title}
      className={className}
      actions={
        <Button
          onPress={() => choose(settings, key, isFolded ? "no" : "yes")}
          icon={<Icon size={14} aria-hidden="true" />}
          label={isFolded ? t("map.fold.open", { title }) : t("map.fold.close", { title })}
        >
          {null}
        </Button>
      }
    >
      {isFolded ? null : children}
    </Panel>
  );
}
