import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import type { NumberField, TopicName } from "../../protocol/topics";
import { AutomaticFlags, OtherAutopilot } from "../../readouts/AutomaticFlags";
import { FmsReadouts } from "../../readouts/FmsReadouts";
import { LiveControlBars, LiveServoBar } from "../../readouts/LiveServoBar";
import { ReadoutTable } from "../../readouts/ReadoutTable";
import { StreamHead } from "../../readouts/StreamPanel";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Tabs } from "../../ui/Tabs";
import { GPS_READOUTS, GpsState } from "./GpsTabs";
import { Refresh } from "./Refresh";

/** The sub tabs with the stream that each shows; two of them show none. */
const TOPICS = {
  fms: "fms_plan",
  gps: "gps",
  servosIn: "servos_in",
  servosOut: null,
  flyByWire: "fly_by_wire",
  refresh: null,
} as const satisfies Readonly<Record<string, TopicName | null>>;
type TabName = keyof typeof TOPICS;

function isTab(name: string | undefined): name is TabName {
  return name !== undefined && name in TOPICS;
}

/** The lower sub tabs: the flight plan, the whole GPS, the servos, the fly-by-wire's controls, the tasks' periods. */
export function BoardTabs({ servosOut }: { servosOut: ReactNode }) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const tab = useSettings(({ choices }) =>
    isTab(choices["flight.board"]) ? choices["flight.board"] : "fms",
  );
  const topic = TOPICS[tab];
  return (
    <Tabs
      label={t("flight.boardTabs")}
      size="sub"
      className="live-card"
      trailing={topic === null ? null : <StreamHead topic={topic} />}
      value={tab}
      onValueChange={(value) => choose(settings, "flight.board", value)}
      tabs={[
        { value: "fms", label: t("flight.fms"), content: <Fms /> },
        { value: "gps", label: t("flight.gps"), content: <Gps /> },
        { value: "servosIn", label: t("flight.servosIn"), content: <ServosIn /> },
        { value: "servosOut", label: t("flight.servosOut"), content: servosOut },
        { value: "flyByWire", label: t("flight.flyByWire"), content: <FlyByWire /> },
        { value: "refresh", label: t("flight.refresh"), content: <Refresh /> },
      ]}
    />
  );
}

function Fms() {
  return (
    <>
      <FmsReadouts topic="fms_plan" columns={3} />
      <div className="flight-automatic">
        <AutomaticFlags of="flight" />
      </div>
      <OtherAutopilot />
    </>
  );
}

function Gps() {
  return (
    <>
      <ReadoutTable {...GPS_READOUTS} columns={3} />
      <GpsState />
    </>
  );
}

const CHANNELS = [
  "channel_0",
  "channel_1",
  "channel_2",
  "channel_3",
  "channel_4",
  "channel_5",
  "channel_6",
  "channel_7",
  "channel_8",
  "channel_9",
  "channel_10",
  "channel_11",
] as const satisfies readonly NumberField<"servos_in">[];

function ServosIn() {
  const { t } = useTranslation();
  return (
    <div className="flight-servos">
      {CHANNELS.map((field, index) => (
        <LiveServoBar
          key={field}
          topic="servos_in"
          field={field}
          label={t("servo.channel", { number: index + 1 })}
        />
      ))}
    </div>
  );
}

function FlyByWire() {
  return (
    <div className="flight-surfaces">
      <LiveControlBars topic="fly_by_wire" controls={["aileron", "elevator", "rudder", "throttle"]} />
    </div>
  );
}
