import { useTranslation } from "react-i18next";
import { FmsReadouts } from "../../readouts/FmsReadouts";
import { LiveControlBars } from "../../readouts/LiveServoBar";
import {
  ANGLE,
  COORDINATE,
  FINE_ANGLE,
  HEADING,
  LOAD,
  THOUSANDTHS,
  TURN_RATE,
} from "../../readouts/notations";
import { type ReadoutGroup, ReadoutPanel } from "../../readouts/ReadoutTable";
import { StreamPanel } from "../../readouts/StreamPanel";
import { useConnection } from "../../store/hooks";
import "./hil.css";

/** The six groups of the simulator's rows. */
const GROUPS: readonly ReadoutGroup[] = [
  {
    titleKey: "hil.ahrs",
    className: "hil-ahrs",
    size: "large",
    topic: "simulator",
    rows: [
      { field: "true_heading_deg", label: "attitude.heading", as: HEADING },
      { field: "pitch_deg", label: "attitude.pitch", as: ANGLE },
      { field: "roll_deg", label: "attitude.roll", as: ANGLE },
    ],
  },
  {
    titleKey: "hil.ads",
    className: "hil-ads",
    size: "large",
    topic: "simulator",
    rows: [
      {
        field: "indicated_airspeed_kt",
        label: "hil.airspeed",
        hint: "hilHint.airspeed",
        as: "speed",
        unit: "unit.kias",
      },
      { field: "altitude_indicated_ft", label: "hil.altitude", as: "altitude" },
    ],
  },
  {
    titleKey: "hil.gps",
    className: "hil-gps",
    topic: "simulator",
    rows: [
      { field: "latitude_deg", label: "gps.latitude", as: COORDINATE, chars: 10 },
      { field: "longitude_deg", label: "gps.longitude", as: COORDINATE, chars: 10 },
      { field: "altitude_msl_ft", label: "gps.altitude", as: "altitude" },
    ],
  },
  {
    titleKey: "hil.gyros",
    className: "hil-gyros",
    topic: "simulator",
    rows: [
      { field: "q_rad_s", label: "axis.q", as: TURN_RATE },
      { field: "p_rad_s", label: "axis.p", as: TURN_RATE },
      { field: "r_rad_s", label: "axis.r", as: TURN_RATE },
    ],
  },
  {
    titleKey: "hil.paths",
    className: "hil-paths",
    topic: "simulator",
    rows: [
      { field: "alpha_deg", label: "hil.alpha", hint: "hilHint.alpha", as: FINE_ANGLE },
      { field: "beta_deg", label: "hil.beta", hint: "hilHint.beta", as: FINE_ANGLE },
      {
        field: "horizontal_path_deg",
        label: "hil.horizontalPath",
        hint: "hilHint.horizontalPath",
        as: HEADING,
      },
      { field: "vertical_path_deg", label: "hil.verticalPath", hint: "hilHint.verticalPath", as: FINE_ANGLE },
    ],
  },
  {
    titleKey: "hil.loads",
    className: "hil-loads",
    topic: "simulator",
    rows: [
      { field: "mach", label: "hil.mach", as: THOUSANDTHS },
      { field: "vvi_ft_min", label: "hil.vvi", hint: "hilHint.vvi", as: "verticalSpeed" },
      { field: "g_normal", label: "hil.gNormal", hint: "hilHint.gNormal", as: LOAD },
      { field: "g_axial", label: "hil.gAxial", hint: "hilHint.gAxial", as: LOAD },
      { field: "g_side", label: "hil.gSide", hint: "hilHint.gSide", as: LOAD },
    ],
  },
];

/** "HIL": what the simulator says, what the board answers, and the plan that it flies there. */
export function HilView() {
  const { t } = useTranslation();
  const isPaused = useConnection(
    ({ phase, status }) => phase === "open" && status?.simulator.paused === true,
  );
  return (
    <div className="hil" data-paused={isPaused}>
      <p role="status" className="hil-paused">
        {isPaused && <strong>{t("hil.paused")}</strong>}
      </p>
      {GROUPS.map((group) => (
        <ReadoutPanel key={group.titleKey} {...group} />
      ))}
      <StreamPanel topic="hil_surfaces" title={t("hil.flyByWire")} className="hil-surfaces">
        <LiveControlBars topic="hil_surfaces" controls={["elevator", "aileron", "rudder", "throttle"]} />
      </StreamPanel>
      <StreamPanel topic="fms_hil_plan" title={t("hil.fms")} className="hil-fms">
        <FmsReadouts topic="fms_hil_plan" columns={3} />
      </StreamPanel>
    </div>
  );
}
