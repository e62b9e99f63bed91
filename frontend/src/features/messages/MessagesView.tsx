import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import type { Inspection } from "../../protocol/contract";
import { LivePlot } from "../../readouts/LivePlot";
import { useConnection, usePage, useSettings } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { choose } from "../../store/settings";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { Tabs } from "../../ui/Tabs";
import { AdviceList } from "./AdviceList";
import { LinkPage } from "./LinkPage";
import { frameLine, ownUnits, rowLine } from "./lines";
import { MessageTable } from "./MessageTable";
import "./messages.css";
import { type PlotKeyText, parsePlotted, signalOf, toggled } from "./plotted";
import { useInspection } from "./useInspection";

const TABS = ["board", "simulator", "link"] as const;
type TabName = (typeof TABS)[number];

/** "Mensajes": every message type of both links, their load, and advice. */
export function MessagesView() {
  const found = useInspection();
  const { plotted, toggle } = usePlotted();
  return (
    <div className="messages" data-plotted={plotted.length > 0}>
      <Findings found={found} plotted={plotted} onToggle={toggle} />
      <PlotPanel plotted={plotted} found={found} />
    </div>
  );
}

interface Toggle {
  plotted: readonly PlotKeyText[];
  onToggle: (key: PlotKeyText) => void;
}

function Findings({ found, ...toggling }: Toggle & { found: Inspection | Message | null }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  if (found === null) {
    return <p className="messages-waiting">{t("messages.waiting")}</p>;
  }
  if ("key" in found) {
    return (
      <div className="messages-waiting">
        <Notice level="error">{sentence(found)}</Notice>
      </div>
    );
  }
  return (
    <>
      <AdviceList advice={found.advice} />
      <Inspected inspection={found} {...toggling} />
    </>
  );
}

interface PlotChoice {
  readonly plotted: readonly PlotKeyText[];
  readonly toggle: (key: PlotKeyText) => void;
}

/** The plotted values: stored, so that they survive a change of tabs. */
function usePlotted(): PlotChoice {
  const { settings } = usePage();
  const text = useSettings(({ choices }) => choices["messages.plotted"]);
  const profile = useConnection(({ status }) => status?.simulator.profile ?? "xp10");
  const plotted = parsePlotted(text, profile);
  return {
    plotted,
    toggle: (key) => choose(settings, "messages.plotted", toggled(plotted, key).join(" ")),
  };
}

function Inspected({ inspection, ...toggling }: Toggle & { inspection: Inspection }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const profile = useConnection(({ status }) => status?.simulator.profile ?? "xp10");
  const tab = useSettings(
    ({ choices }): TabName => TABS.find((name) => name === choices["messages.tab"]) ?? "board",
  );
  return (
    <Tabs
      label={t("messages.tabs")}
      size="sub"
      className="messages-tabs"
      value={tab}
      onValueChange={(value) => choose(settings, "messages.tab", value)}
      tabs={[
        {
          value: "board",
          label: t("messages.board"),
          content: (
            <MessageTable
              {...toggling}
              label={t("messages.boardTable")}
              lines={inspection.board.map(frameLine)}
              hasDamage
            />
          ),
        },
        {
          value: "simulator",
          label: t("messages.simulator"),
          content: (
            <MessageTable
              {...toggling}
              label={t("messages.simulatorTable")}
              lines={inspection.rows.map((row) => rowLine(row, profile))}
            />
          ),
        },
        { value: "link", label: t("messages.link"), content: <LinkPage link={inspection.link} /> },
      ]}
    />
  );
}

interface PlotPanelProps {
  plotted: readonly PlotKeyText[];
  found: Inspection | Message | null;
}

function PlotPanel({ plotted, found }: PlotPanelProps) {
  const { t } = useTranslation();
  const units = ownUnits(found === null || "key" in found ? [] : found.board);
  const profile = useConnection(({ status }) => status?.simulator.profile ?? "xp10");
  const signals = plotted.map((key) => signalOf(key, profile, units)).filter((signal) => signal !== null);
  return signals.length === 0 ? null : (
    <Panel title={t("messages.plot")} className="messages-plot">
      <LivePlot signals={signals} label={t("messages.plot")} />
    </Panel>
  );
}
