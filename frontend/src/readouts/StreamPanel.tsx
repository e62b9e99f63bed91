import "./readouts.css";
import { Power } from "lucide-react";
import { type ReactNode, useCallback, useRef } from "react";
import { useTranslation } from "react-i18next";
import { formatAge } from "../lib/format";
import type { TopicName } from "../protocol/topics";
import { CommandButton } from "../requests/CommandButton";
import { useConnection, useTelemetry } from "../store/hooks";
import type { TelemetryStore } from "../store/telemetry";
import { usePaint } from "../store/usePaint";
import { Panel } from "../ui/Panel";
import { StreamBadge, type StreamBadgeHandle } from "../ui/StreamBadge";
import { STREAMS } from "./streams";

interface Props {
  topic: TopicName;
  title: string;
  hint?: string | undefined;
  level?: 2 | 3;
  className?: string;
  /** Without the rate, for a narrow panel. */
  narrow?: boolean;
  /** No landmark: another panel has the same title. */
  plain?: boolean;
  children: ReactNode;
}

/** A panel for one stream: its freshness, and a switch if it is off. */
export function StreamPanel(props: Props) {
  const { topic, title, hint, level, className, narrow = false, plain, children } = props;
  const isOff = useStreamIsOff(topic);
  return (
    <Panel
      title={title}
      hint={hint}
      level={level}
      className={className}
      plain={plain}
      badge={isOff ? undefined : <LiveBadge topic={topic} narrow={narrow} />}
      actions={isOff ? <StreamOff topic={topic} narrow={narrow} /> : undefined}
    >
      {children}
    </Panel>
  );
}

/** The same head for a row of sub tabs: the state of the open tab's topic, or its switch. */
export function StreamHead({ topic, narrow = false }: { topic: TopicName; narrow?: boolean }) {
  const isOff = useStreamIsOff(topic);
  return (
    <div className="live-head">
      {isOff ? <StreamOff topic={topic} narrow={narrow} /> : <LiveBadge topic={topic} narrow={narrow} />}
    </div>
  );
}

/** The state of a topic in a panel's head: its rate while it is live, else its age. */
export function LiveBadge({ topic, narrow = false }: { topic: TopicName; narrow?: boolean }) {
  const badge = useRef<StreamBadgeHandle>(null);
  const rate_hz = useConnection(({ rates_hz }) => rates_hz[topic] ?? null);
  const paint = useCallback(
    (telemetry: TelemetryStore, now_ms: number) => {
      const state = telemetry.state(topic, now_ms);
      const age_s = telemetry.age_s(topic, now_ms);
      const rate =
        rate_hz === null || narrow ? "" : `${rate_hz >= 9.5 ? rate_hz.toFixed(0) : rate_hz.toFixed(1)} Hz`;
      badge.current?.paint(state, state === "live" ? rate : age_s === null ? "" : formatAge(age_s));
    },
    [topic, rate_hz, narrow],
  );
  usePaint("text", paint);
  return (
    <span className="live-badge" data-narrow={narrow}>
      <StreamBadge ref={badge} />
    </span>
  );
}

/** Shows that a stream is off, with a button that switches it on: a command like any other, with its proof. */
export function StreamOff({ topic, narrow }: { topic: TopicName; narrow: boolean }) {
  const { t } = useTranslation();
  const stream = STREAMS[topic];
  return stream === undefined ? null : (
    <>
      <span className={narrow ? "visually-hidden" : "live-off"}>{t("stream.off")}</span>
      {narrow ? (
        <CommandButton
          command={stream.on}
          icon={<Power aria-hidden="true" size={14} />}
          label={t("stream.switchOn")}
        />
      ) : (
        <CommandButton command={stream.on}>{t("stream.switchOn")}</CommandButton>
      )}
    </>
  );
}

/**
 * Whether the board reports that it does not send this: by its flag in a live heartbeat; for a stream without a flag,
 * by its silence.
 */
export function useStreamIsOff(topic: TopicName): boolean {
  const stream = STREAMS[topic];
  return useTelemetry((telemetry, now_ms) => {
    if (stream === undefined || telemetry.state("heartbeat", now_ms) !== "live") {
      return false;
    }
    return stream.flag === null
      ? telemetry.state(topic, now_ms) !== "live"
      : telemetry.newestFlag("heartbeat", stream.flag) === false;
  });
}
