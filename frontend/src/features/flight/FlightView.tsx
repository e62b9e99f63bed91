import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { degreesPerSecond, heading, hundredths, tenths, thousandths } from "../../readouts/formats";
import { LiveReadout } from "../../readouts/LiveReadout";
import { StreamPanel } from "../../readouts/StreamPanel";
import { ReadoutGrid } from "../../ui/Readout";
import { BoardTabs } from "./BoardTabs";
import "./flight.css";
import { GpsTabs } from "./GpsTabs";
import { StateReport } from "./StateReport";

/** "Datos de vuelo": everything that the board measures and works out. */
export function FlightView({ servosOut }: { servosOut: ReactNode }) {
  return (
    <div className="flight">
      <AhrsPanel />
      <StateReport />
      <div className="flight-gps">
        <GpsTabs />
      </div>
      <InertialPanels />
      <AnalogPanel />
      <div className="flight-board">
        <BoardTabs servosOut={servosOut} />
      </div>
    </div>
  );
}

function AhrsPanel() {
  const { t } = useTranslation();
  const deg = t("unit.deg");
  return (
    <StreamPanel topic="ahrs" title={t("flight.ahrs")} className="flight-ahrs">
      <ReadoutGrid>
        <LiveReadout
          topic="ahrs"
          field="yaw_deg"
          format={heading}
          label={t("attitude.heading")}
          unit={deg}
          size="large"
          chars={6}
        />
        <LiveReadout
          topic="ahrs"
          field="pitch_deg"
          format={tenths}
          label={t("attitude.pitch")}
          unit={deg}
          size="large"
          chars={6}
        />
        <LiveReadout
          topic="ahrs"
          field="roll_deg"
          format={tenths}
          label={t("attitude.roll")}
          unit={deg}
          size="large"
          chars={6}
        />
      </ReadoutGrid>
    </StreamPanel>
  );
}

function InertialPanels() {
  const { t } = useTranslation();
  const rate = t("unit.degPerS");
  const acceleration = t("unit.mPerS2");
  return (
    <>
      <StreamPanel topic="inertial" title={t("flight.gyros")} className="flight-gyros" narrow>
        <ReadoutGrid>
          <LiveReadout
            topic="inertial"
            field="gx_rad_s"
            format={degreesPerSecond}
            label={t("axis.p")}
            unit={rate}
          />
          <LiveReadout
            topic="inertial"
            field="gy_rad_s"
            format={degreesPerSecond}
            label={t("axis.q")}
            unit={rate}
          />
          <LiveReadout
            topic="inertial"
            field="gz_rad_s"
            format={degreesPerSecond}
            label={t("axis.r")}
            unit={rate}
          />
        </ReadoutGrid>
      </StreamPanel>
      <StreamPanel
        topic="inertial"
        title={t("flight.accelerometers")}
        className="flight-accelerometers"
        narrow
      >
        <ReadoutGrid>
          <LiveReadout
            topic="inertial"
            field="accx_m_s2"
            format={hundredths}
            label={t("axis.x")}
            unit={acceleration}
          />
          <LiveReadout
            topic="inertial"
            field="accy_m_s2"
            format={hundredths}
            label={t("axis.y")}
            unit={acceleration}
          />
          <LiveReadout
            topic="inertial"
            field="accz_m_s2"
            format={hundredths}
            label={t("axis.z")}
            unit={acceleration}
          />
        </ReadoutGrid>
      </StreamPanel>
      <StreamPanel topic="inertial" title={t("flight.magnetometers")} className="flight-magnetometers" narrow>
        <ReadoutGrid>
          <LiveReadout topic="inertial" field="magx" format={thousandths} label={t("axis.x")} />
          <LiveReadout topic="inertial" field="magy" format={thousandths} label={t("axis.y")} />
          <LiveReadout topic="inertial" field="magz" format={thousandths} label={t("axis.z")} />
        </ReadoutGrid>
      </StreamPanel>
    </>
  );
}

function AnalogPanel() {
  const { t } = useTranslation();
  return (
    <StreamPanel topic="analog" title={t("flight.analog")} className="flight-analog">
      <ReadoutGrid columns={2}>
        <LiveReadout
          topic="analog"
          chars={6}
          field="temperature_degc"
          quantity="temperature"
          label={t("analog.temperature")}
        />
        <LiveReadout
          topic="analog"
          chars={6}
          field="battery_v"
          format={hundredths}
          label={t("analog.battery")}
          unit={t("unit.v")}
        />
        <LiveReadout
          topic="analog"
          chars={6}
          field="baro_hpa"
          format={tenths}
          label={t("analog.baro")}
          unit={t("unit.hpa")}
        />
        <LiveReadout
          topic="analog"
          chars={6}
          field="altitude_m"
          quantity="altitude"
          label={t("analog.altitude")}
        />
        <LiveReadout
          topic="analog"
          chars={6}
          field="pitot_pa"
          format={tenths}
          label={t("analog.pitot")}
          unit={t("unit.pa")}
        />
        <LiveReadout
          topic="analog"
          chars={6}
          field="calibrated_airspeed_kt"
          quantity="speed"
          label={t("analog.speed")}
        />
      </ReadoutGrid>
    </StreamPanel>
  );
}
