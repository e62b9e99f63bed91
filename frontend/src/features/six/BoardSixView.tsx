import { useTranslation } from "react-i18next";
import { heading, tenths } from "../../readouts/formats";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { boardBearing_deg, boardHeading_deg, flownPlan, LiveHeading } from "../../readouts/LiveHeading";
import { LiveReadout } from "../../readouts/LiveReadout";
import { useTelemetry } from "../../store/hooks";
import { LiveAirspeed, LiveAltimeter, LiveVerticalSpeed } from "./LiveDial";
import { SixCell, SixGrid, useSource } from "./SixCell";
import {
  baroAltitude_ft,
  boardVerticalSpeed_ft_min,
  gpsAltitude_ft,
  gpsSpeed_kt,
  isGpsSpeed,
  pitotAirspeed_kt,
} from "./sources";

/** "Standard Six": what the board measures, on the six instruments of every cockpit. */
export function BoardSixView() {
  const { t } = useTranslation();
  const source = useSource();
  const deg = t("unit.deg");
  return (
    <SixGrid>
      <Airspeed />
      <SixCell topic="ahrs" title={t("six.attitude")} dial={<LiveAttitude topic="ahrs" />}>
        <LiveReadout
          topic="ahrs"
          field="pitch_deg"
          format={tenths}
          label={source("hil.ahrs", "attitude.pitch")}
          unit={deg}
          chars={5}
        />
        <LiveReadout
          topic="ahrs"
          field="roll_deg"
          format={tenths}
          label={t("attitude.roll")}
          unit={deg}
          chars={5}
        />
      </SixCell>
      <SixCell
        topic="analog"
        title={t("six.altimeterBaro")}
        dial={
          <LiveAltimeter
            read={baroAltitude_ft}
            label={t("six.altimeterBaro")}
            caption={t("six.captionBaro")}
          />
        }
      >
        <LiveReadout
          topic="analog"
          field="altitude_m"
          quantity="altitude"
          label={source("flight.analog", "analog.altitude")}
        />
      </SixCell>
      <SixCell
        topic="gps"
        title={t("six.altimeterGps")}
        dial={
          <LiveAltimeter read={gpsAltitude_ft} label={t("six.altimeterGps")} caption={t("six.captionGps")} />
        }
      >
        <LiveReadout
          topic="gps"
          field="altitude_m"
          quantity="altitude"
          label={source("flight.gps", "gps.altitude")}
        />
      </SixCell>
      <SixCell
        topic="ahrs"
        title={t("six.heading")}
        dial={<LiveHeading heading_deg={boardHeading_deg} bearing_deg={boardBearing_deg} />}
      >
        <LiveReadout
          topic="ahrs"
          field="yaw_deg"
          format={heading}
          label={source("hil.ahrs", "attitude.heading")}
          unit={deg}
          chars={5}
        />
        <Bug />
      </SixCell>
      <SixCell
        topic="analog"
        title={t("six.verticalSpeed")}
        dial={
          <LiveVerticalSpeed
            read={boardVerticalSpeed_ft_min}
            label={t("six.verticalSpeed")}
            caption={t("six.captionVerticalSpeed")}
          />
        }
      >
        <LiveReadout
          topic="analog"
          field="vvi_ft_min"
          quantity="verticalSpeed"
          label={source("flight.analog", "hil.vvi")}
        />
      </SixCell>
    </SixGrid>
  );
}

/** What the bug shows, named by the plan from which it comes. */
function Bug() {
  const { t } = useTranslation();
  const source = useSource();
  const plan = useTelemetry(flownPlan);
  return (
    <LiveReadout
      topic={plan}
      field="bearing_deg"
      format={heading}
      label={source(plan === "fms_plan" ? "flight.fms" : "six.fmsHil", "fms.bearing")}
      unit={t("unit.deg")}
      chars={5}
    />
  );
}

/** The airspeed is the one that the board flies by, and says which. */
function Airspeed() {
  const { t } = useTranslation();
  const source = useSource();
  const isGps = useTelemetry(isGpsSpeed);
  return isGps ? (
    <SixCell
      topic="gps"
      title={t("six.airspeed")}
      dial={<LiveAirspeed read={gpsSpeed_kt} label={t("six.airspeed")} caption={t("six.captionGps")} />}
    >
      <LiveReadout topic="gps" field="speed_kt" quantity="speed" label={source("flight.gps", "gps.speed")} />
    </SixCell>
  ) : (
    <SixCell
      topic="analog"
      title={t("six.airspeed")}
      dial={
        <LiveAirspeed read={pitotAirspeed_kt} label={t("six.airspeed")} caption={t("six.captionPitot")} />
      }
    >
      <LiveReadout
        topic="analog"
        field="calibrated_airspeed_kt"
        quantity="speed"
        label={source("flight.analog", "analog.speed")}
      />
    </SixCell>
  );
}
