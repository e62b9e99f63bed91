import {
  BellRing,
  Box,
  ChartLine,
  Gauge,
  Globe,
  LayoutGrid,
  type LucideIcon,
  MessageSquareText,
  Monitor,
  Plane,
  Route,
  SlidersHorizontal,
  Table2,
  Video,
  Wrench,
} from "lucide-react";
import type { TabName } from "../views/views";

const ICONS: Readonly<Record<TabName, LucideIcon>> = {
  fly: Plane,
  flight: Table2,
  six: Gauge,
  params: SlidersHorizontal,
  hil: Monitor,
  hilSix: LayoutGrid,
  plans: Route,
  map: Globe,
  ahrs3d: Box,
  messages: MessageSquareText,
  plots: ChartLine,
  alarms: BellRing,
  setup: Wrench,
  flights: Video,
};

export function TabIcon({ tab }: { readonly tab: TabName }) {
  const Icon = ICONS[tab];
  return <Icon size={20} aria-hidden="true" />;
}
