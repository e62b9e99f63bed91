import { type Checked, dictionary, isNumber, isText, list, nullable, oneOf, shape } from "../lib/check";

const isRoundTrip = shape({ newest: nullable(isNumber), p50: nullable(isNumber), p99: nullable(isNumber) });

/** The gateway's status, as much of it as the page shows. It comes twice a second and at every change. */
export const isStatus = shape({
  version: isText,
  board: shape({
    state: oneOf("closed", "opening", "open", "lost"),
    url: nullable(isText),
    mode: nullable(oneOf("legacy", "extended")),
    heartbeat_age_s: nullable(isNumber),
    frames_received: isNumber,
    frames_damaged: isNumber,
    rx_percent: isNumber,
    tx_percent: isNumber,
  }),
  simulator: shape({
    state: oneOf("closed", "opening", "open", "lost"),
    rows: list(isNumber),
    datagrams_received: isNumber,
    datagrams_dropped: isNumber,
    percent: isNumber,
    hil_round_trip_ms: isRoundTrip,
  }),
  hil: shape({ source: nullable(oneOf("joystick", "rc")), path: oneOf("manual", "assisted") }),
  control: shape({ client: nullable(isText), name: nullable(isText) }),
  recording: shape({ file: nullable(isText), bytes: isNumber }),
  topics: dictionary(shape({ stale_after_s: nullable(isNumber), rate_hz: isNumber })),
  alarms: list(shape({ id: isText, level: oneOf("warning", "critical"), since_s: isNumber, text: isText })),
});

export type Status = Checked<typeof isStatus>;
export type Alarm = Status["alarms"][number];
