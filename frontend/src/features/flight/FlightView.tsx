import type { ReactNode } from "react";
import { ACCELERATION, HECTOPASCALS, PASCALS, THOUSANDTHS, VOLTAGE } from "../../readouts/notations";
import { type ReadoutGroup, ReadoutPanel } from "../../readouts/ReadoutTable";
import { ATTITUDE, TURN_RATES } from "../../readouts/rows";
import { BoardTabs } from "./BoardTabs";
import "./flight.css";
import { GpsTabs } from "./GpsTabs";
import { StateReport } from "./StateReport";

const SENSORS: readonly ReadoutGroup[] = [
  { ...TURN_RATES, titleKey: "flight.gyros", className: "flight-gyros", narrow: true },
  {
    titleKey: "flight.accelerometers",
    className: "flight-accelerometers",
    narrow: true,
    topic: "inertial",
    rows: [
      { field: "accx_m_s2", label: "axis.x", as: ACCELERATION },
      { field: "accy_m_s2", label: "axis.y", as: ACCELERATION },
      { field: "accz_m_s2", label: "axis.z", as: ACCELERATION },
    ],
  },
  {
    titleKey: "flight.magnetometers",
    className: "flight-magnetometers",
    narrow: true,
    topic: "inertial",
    rows: [
      { field: "magx", label: "axis.x", as: THOUSANDTHS },
      { field: "magy", label: "axis.y", as: THOUSANDTHS },
      { field: "magz", label: "axis.z", as: THOUSANDTHS },
    ],
  },
  {
    titleKey: "flight.analog",
    className: "flight-analog",
    columns: 2,
    chars: 6,
    topic: "analog",
    rows: [
      { field: "temperature_degc", label: "analog.temperature", as: "temperature" },
      { field: "battery_v", label: "analog.battery", as: VOLTAGE },
      { field: "baro_hpa", label: "analog.baro", as: HECTOPASCALS },
      { field: "altitude_m", label: "analog.altitude", as: "altitude" },
      { field: "pitot_pa", label: "analog.pitot", as: PASCALS },
      { field: "calibrated_airspeed_kt", label: "analog.speed", as: "speed" },
    ],
  },
];

/** "Datos de vuelo": everything that the board measures and works out. */
export function FlightView({ servosOut }: { servosOut: ReactNode }) {
  return (
    <div className="flight">
      <ReadoutPanel
        {...ATTITUDE}
        titleKey="flight.ahrs"
        hintKey="termHint.ahrs"
        className="flight-ahrs"
        size="large"
        chars={6}
      />
      <StateReport />
      <div className="flight-gps">
        <GpsTabs />
      </div>
      {SENSORS.map((group) => (
        <ReadoutPanel key={group.titleKey} {...group} />
      ))}
      <div className="flight-board">
        <BoardTabs servosOut={servosOut} />
      </div>
    </div>
  );
}
