import { useTranslation } from "react-i18next";
import { coordinate, heading, whole } from "../../readouts/formats";
import { LiveFlag, type ReadFlag } from "../../readouts/LiveFlag";
import { LiveReadout } from "../../readouts/LiveReadout";
import { StreamHead } from "../../readouts/StreamPanel";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { ReadoutGrid } from "../../ui/Readout";
import { Tabs } from "../../ui/Tabs";

/** A fix is there when the receiver gives its kind and does not call it void. */
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
        { value: "fast", label: t("flight.fastGps"), content: <GpsReadouts /> },
        { value: "status", label: t("flight.gpsStatus"), content: <GpsState /> },
        { value: "cpu", label: t("flight.cpu"), content: <Cpu /> },
      ]}
    />
  );
}

/** Position, height, speed and track of the receiver. */
export function GpsReadouts({ columns = 1 }: { columns?: number }) {
  const { t } = useTranslation();
  return (
    <ReadoutGrid columns={columns}>
      <LiveReadout
        topic="gps"
        field="latitude_deg"
        format={coordinate}
        label={t("gps.latitude")}
        unit={t("unit.deg")}
        chars={11}
      />
      <LiveReadout
        topic="gps"
        field="longitude_deg"
        format={coordinate}
        label={t("gps.longitude")}
        unit={t("unit.deg")}
        chars={11}
      />
      <LiveReadout topic="gps" field="altitude_m" quantity="altitude" label={t("gps.altitude")} />
      <LiveReadout topic="gps" field="speed_kt" quantity="speed" label={t("gps.speed")} />
      <LiveReadout
        topic="gps"
        field="heading_deg"
        format={heading}
        label={t("gps.heading")}
        unit={t("unit.deg")}
      />
    </ReadoutGrid>
  );
}

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
      <ReadoutGrid>
        <LiveReadout topic="gps" field="satellites" format={whole} label={t("gps.satellites")} chars={3} />
      </ReadoutGrid>
    </div>
  );
}

function Cpu() {
  const { t } = useTranslation();
  const percent = t("unit.percent");
  return (
    <ReadoutGrid>
      <LiveReadout
        topic="statistics"
        field="sensor_dsc_percent"
        format={whole}
        label={t("cpu.sensor")}
        unit={percent}
        chars={4}
      />
      <LiveReadout
        topic="statistics"
        field="control_dsc_percent"
        format={whole}
        label={t("cpu.control")}
        unit={percent}
        chars={4}
      />
    </ReadoutGrid>
  );
}
