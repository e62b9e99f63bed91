import { useTranslation } from "react-i18next";
import { heading, tenths } from "../../readouts/formats";
import { LiveAttitude } from "../../readouts/LiveAttitude";
import { LiveHeading } from "../../readouts/LiveHeading";
import { LiveReadout } from "../../readouts/LiveReadout";
import { LiveAirspeed, LiveAltimeter, LiveVerticalSpeed } from "./LiveDial";
import { SixCell, SixGrid, useSource } from "./SixCell";
import {
  hilBearing_deg,
  simulatorAirspeed_kt,
  simulatorBaroAltitude_ft,
  simulatorGpsAltitude_ft,
  simulatorHeading_deg,
  simulatorVerticalSpeed_ft_min,
} from "./sources";

/** "HIL Standard Six": the same six instruments from the simulator's values. */
export function HilSixView() {
  const { t } = useTranslation();
  const source = useSource();
  const deg = t("unit.deg");
  return (
    <SixGrid>
      <SixCell
        topic="simulator"
        title={t("six.airspeed")}
        dial={
          <LiveAirspeed
            read={simulatorAirspeed_kt}
            label={t("six.airspeed")}
            caption={t("six.captionIndicated")}
          />
        }
      >
        <LiveReadout
          topic="simulator"
          field="indicated_airspeed_kt"
          quantity="speed"
          unit={t("unit.kias")}
          label={source("hil.ads", "hil.airspeed")}
        />
      </SixCell>
      <SixCell topic="simulator" title={t("six.attitude")} dial={<LiveAttitude topic="simulator" />}>
        <LiveReadout
          topic="simulator"
          field="pitch_deg"
          format={tenths}
          label={source("hil.ahrs", "attitude.pitch")}
          unit={deg}
          chars={5}
        />
        <LiveReadout
          topic="simulator"
          field="roll_deg"
          format={tenths}
          label={t("attitude.roll")}
          unit={deg}
          chars={5}
        />
      </SixCell>
      <SixCell
        topic="simulator"
        title={t("six.altimeterBaro")}
        dial={
          <LiveAltimeter
            read={simulatorBaroAltitude_ft}
            label={t("six.altimeterBaro")}
            caption={t("six.captionBaro")}
          />
        }
      >
        <LiveReadout
          topic="simulator"
          field="altitude_indicated_ft"
          quantity="altitude"
          label={source("hil.ads", "hil.altitude")}
        />
      </SixCell>
      <SixCell
        topic="simulator"
        title={t("six.altimeterGps")}
        dial={
          <LiveAltimeter
            read={simulatorGpsAltitude_ft}
            label={t("six.altimeterGps")}
            caption={t("six.captionGps")}
          />
        }
      >
        <LiveReadout
          topic="simulator"
          field="altitude_msl_ft"
          quantity="altitude"
          label={source("hil.gps", "gps.altitude")}
        />
      </SixCell>
      <SixCell
        topic="simulator"
        title={t("six.heading")}
        dial={<LiveHeading heading_deg={simulatorHeading_deg} bearing_deg={hilBearing_deg} />}
      >
        <LiveReadout
          topic="simulator"
          field="true_heading_deg"
          format={heading}
          label={source("hil.ahrs", "attitude.heading")}
          unit={deg}
          chars={5}
        />
        <LiveReadout
          topic="fms_hil_plan"
          field="bearing_deg"
          format={heading}
          label={source("six.fmsHil", "fms.bearing")}
          unit={deg}
          chars={5}
        />
      </SixCell>
      <SixCell
        topic="simulator"
        title={t("six.verticalSpeed")}
        dial={
          <LiveVerticalSpeed
            read={simulatorVerticalSpeed_ft_min}
            label={t("six.verticalSpeed")}
            caption={t("six.captionVerticalSpeed")}
          />
        }
      >
        <LiveReadout
          topic="simulator"
          field="vvi_ft_min"
          quantity="verticalSpeed"
          label={source("hil.loads", "hil.vvi")}
        />
      </SixCell>
    </SixGrid>
  );
}
