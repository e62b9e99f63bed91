import { useTranslation } from "react-i18next";
import { LiveFlag, type ReadFlag } from "../../readouts/LiveFlag";
import type { ReadoutRows } from "../../readouts/LiveReadout";
import { COORDINATE, COUNT, HEADING, PERCENT } from "../../readouts/notations";
import { ReadoutTable } from "../../readouts/ReadoutTable";
import { StreamHead } from "../../readouts/StreamPanel";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Tabs } from "../../ui/Tabs";

/** There is a fix when the receiver reports its kind and does not mark it invalid. */
export const hasFix: ReadFlag = (telemetry) => {
  const fix = telemetry.newestNumber("gps", "fix");
  return fix === null ? null : fix > 0 && telemetry.newestFlag("gps", "valid") !== false;
};

const TABS = ["fast", "status", "cpu"] as const;

/** The upper sub tabs: position at a glance, the receiver's state, the load of the two processors. */
export function GpsTabs() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const tab = useSettings(({ choices }) => TABS.find((name) => name === choices["flight.gps"]) ?? "fast");
  return (
    <Tabs
      label={t("flight.gpsTabs")}
      size="sub"
      className="live-card"
      trailing={<StreamHead topic={tab === "cpu" ? "statistics" : "gps"} narrow />}
      value={tab}
      onValueChange={(value) => choose(settings, "flight.gps", value)}
      tabs={[
        { value: "fast", label: t("flight.fastGps"), content: <ReadoutTable {...GPS_READOUTS} /> },
        { value: "status", label: t("flight.gpsStatus"), content: <GpsState /> },
        { value: "cpu", label: t("flight.cpu"), content: <ReadoutTable {...PROCESSORS} /> },
      ]}
    />
  );
}

/** Position, height, speed and track of the receiver. */
export const GPS_READOUTS: ReadoutRows = {
  topic: "gps",
  rows: [
    { field: "latitude_deg", label: "gps.latitude", as: COORDINATE, chars: 11 },
    { field: "longitude_deg", label: "gps.longitude", as: COORDINATE, chars: 11 },
    { field: "altitude_m", label: "gps.altitude", as: "altitude" },
    { field: "speed_kt", label: "gps.speed", as: "speed" },
    { field: "heading_deg", label: "gps.heading", as: HEADING },
  ],
};

const SATELLITES: ReadoutRows = {
  topic: "gps",
  rows: [{ field: "satellites", label: "gps.satellites", as: COUNT, chars: 3 }],
};

const PROCESSORS: ReadoutRows = {
  topic: "statistics",
  rows: [
    { field: "sensor_dsc_percent", label: "cpu.sensor", as: PERCENT, chars: 4 },
    { field: "control_dsc_percent", label: "cpu.control", as: PERCENT, chars: 4 },
  ],
};

export function GpsState() {
  const { t } = useTranslation();
  return (
    <div className="flight-gps-state">
      <LiveFlag
        topic="gps"
        read={hasFix}
        label={t("gps.fix")}
        texts={{ on: t("gps.fixed"), off: t("gps.noFix") }}
      />
      <ReadoutTable {...SATELLITES} />
    </div>
  );
}
