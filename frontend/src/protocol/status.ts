import {
  type Checked,
  dictionary,
  isFlag,
  isNumber,
  isText,
  list,
  nullable,
  oneOf,
  optional,
  shape,
} from "../lib/check";
import type { components } from "./api.gen";

/** The values that stand in a sentence; those of other types are not shown. */
const isParams = dictionary(
  (value): value is string | number | boolean | null => typeof value !== "object" || value === null,
);
const isFailure = nullable(shape({ code: isText, detail: isText, params: isParams }));
const isPeriod = shape({ ms: isNumber, chosen: isFlag });
const isRoundTrip = shape({ newest: nullable(isNumber), p50: nullable(isNumber), p99: nullable(isNumber) });

/** The gateway's status, as much of it as the page shows. It comes twice a second and at every change. */
export const isStatus = shape({
  version: isText,
  server_time_s: isNumber,
  board: shape({
    state: oneOf("closed", "opening", "open", "lost"),
    url: nullable(isText),
    ahrs_test: oneOf("off", "starting", "running", "ending"),
    emulated: isFlag,
    before_emulation_url: nullable(isText),
    mode: nullable(oneOf("legacy", "extended")),
    features: shape({ acknowledgements: isFlag, store: isFlag, sources: isFlag, missions: isFlag }),
    periods_ms: shape({ parameters: isPeriod, fms: isPeriod, servos: isPeriod }),
    heartbeat_age_s: nullable(isNumber),
    failure: isFailure,
    reopened: isNumber,
    firmware: nullable(shape({ name: nullable(isText), version: nullable(isText) })),
    frames_received: isNumber,
    frames_damaged: isNumber,
    rx_percent: isNumber,
    tx_percent: isNumber,
  }),
  simulator: shape({
    state: oneOf("closed", "opening", "open", "lost"),
    receive_port: nullable(isNumber),
    send_host: nullable(isText),
    send_port: nullable(isNumber),
    profile: nullable(oneOf("xp10", "xp12")),
    failure: isFailure,
    rows: list(isNumber),
    missing_rows: list(isNumber),
    datagrams_received: isNumber,
    datagrams_dropped: isNumber,
    percent: isNumber,
    hil_round_trip_ms: isRoundTrip,
  }),
  hil: shape({
    source: nullable(oneOf("joystick", "rc")),
    path: oneOf("manual", "assisted"),
    // A gateway that runs on while its page is brought up to date may not know of it.
    stick: optional(
      shape({
        source: oneOf("simulator", "gamepad"),
        state: nullable(oneOf("live", "lost")),
        client: nullable(isText),
        name: nullable(isText),
        gamepad: nullable(isText),
      }),
    ),
  }),
  control: shape({ client: nullable(isText), name: nullable(isText) }),
  recording: shape({ active: isFlag, file: nullable(isText), bytes: isNumber, failure: nullable(isText) }),
  topics: dictionary(shape({ count: isNumber, stale_after_s: nullable(isNumber) })),
  alarms: list(
    shape({
      id: isText,
      level: oneOf("warning", "critical"),
      since_s: isNumber,
      text: isText,
      params: isParams,
      acknowledged: isFlag,
    }),
  ),
});

export type Status = Checked<typeof isStatus>;
export type Alarm = Status["alarms"][number];

/** Does not compile when the gateway describes its status otherwise than it is checked here. */
export const statusIsAsDescribed: components["schemas"]["Status"] extends Status ? true : false = true;
