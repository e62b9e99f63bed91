import {
  ChartLine,
  ChevronUp,
  type LucideIcon,
  MessageSquareText,
  Monitor,
  Plane,
  Route,
  SlidersHorizontal,
  Wrench,
} from "lucide-react";
import type { TabGroup } from "../views/views";

const ICONS: Readonly<Record<TabGroup["name"], LucideIcon>> = {
  fly: Plane,
  plans: Route,
  params: SlidersHorizontal,
  hil: Monitor,
  flights: ChartLine,
  said: MessageSquareText,
  setup: Wrench,
};

/** Over the group's name, with a mark where a further press opens a menu of its tabs. */
export function GroupIcon({
  group,
  hasMenu,
}: {
  readonly group: TabGroup["name"];
  readonly hasMenu: boolean;
}) {
  const Icon = ICONS[group];
  return (
    <>
      <Icon size={20} aria-hidden="true" />
      {hasMenu && <ChevronUp className="app-tab-more" size={12} aria-hidden="true" />}
    </>
  );
}
