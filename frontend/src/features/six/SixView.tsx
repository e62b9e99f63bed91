import "./six.css";
import type { ParseKeys } from "i18next";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import type { TopicName } from "../../protocol/topics";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { flownPlan, LiveHeading } from "../../readouts/LiveHeading";
import { LiveReadout } from "../../readouts/LiveReadout";
import { StreamPanel } from "../../readouts/StreamPanel";
import { ATTITUDE_ROWS, isGpsSpeed, type PointerSource, SIX, type Source } from "../../readouts/sources";
import { useTelemetry } from "../../store/hooks";
import { ReadoutGrid } from "../../ui/Readout";
import { LiveAirspeed, LiveAltimeter, LiveVerticalSpeed } from "./LiveDial";

/** "Standard Six": what the board measures, on the six instruments of every cockpit. */
export function BoardSixView() {
  return <SixView aircraft="flight" />;
}

/** "HIL Standard Six": the same six instruments from the simulator's values. */
export function HilSixView() {
  return <SixView aircraft="hil" />;
}

function SixView({ aircraft }: { aircraft: Aircraft }) {
  const six = SIX[aircraft];
  const { attitude, heading, bearing_deg } = six;
  const bug = six.bug(useTelemetry(flownPlan));
  const attitudes = ATTITUDE_ROWS.map((row) => ({ topic: attitude, row: { ...row, chars: 5 } }));
  return (
    <div className="six">
      <div className="six-grid">
        <Pointer
          titleKey="six.airspeed"
          dial={LiveAirspeed}
          source={six.airspeed(useTelemetry(isGpsSpeed))}
        />
        <Cell titleKey="six.attitude" topic={attitude} readouts={attitudes}>
          <LiveAttitude topic={attitude} />
        </Cell>
        <Pointer titleKey="six.altimeterBaro" dial={LiveAltimeter} source={six.altimeterBaro} />
        <Pointer titleKey="six.altimeterGps" dial={LiveAltimeter} source={six.altimeterGps} />
        <Cell titleKey="six.heading" topic={heading.topic} readouts={[heading, bug]}>
          <LiveHeading heading_deg={heading.read} bearing_deg={bearing_deg} />
        </Cell>
        <Pointer titleKey="six.verticalSpeed" dial={LiveVerticalSpeed} source={six.verticalSpeed} />
      </div>
    </div>
  );
}

interface PointerProps {
  titleKey: ParseKeys;
  dial: typeof LiveAltimeter;
  source: PointerSource;
}

function Pointer({ titleKey, dial: Dial, source }: PointerProps) {
  const { t } = useTranslation();
  return (
    <Cell titleKey={titleKey} topic={source.topic} readouts={[source]}>
      <Dial read={source.read} label={t(titleKey)} caption={t(source.caption)} />
    </Cell>
  );
}

interface CellProps {
  titleKey: ParseKeys;
  topic: TopicName;
  /** Where its values come from, with the numbers and their units. */
  readouts: ReadonlyArray<Omit<Source, "read">>;
  /** The instrument. */
  children: ReactNode;
}

/** One instrument with its stream's state over it and its source under it. */
function Cell({ titleKey, topic, readouts, children }: CellProps) {
  const { t } = useTranslation();
  return (
    <StreamPanel topic={topic} title={t(titleKey)} className="six-cell" narrow plain>
      <div className="six-dial">{children}</div>
      <ReadoutGrid className="six-source">
        {readouts.map(({ topic: from, row }) => (
          <LiveReadout key={row.label} topic={from} {...row} />
        ))}
      </ReadoutGrid>
    </StreamPanel>
  );
}
