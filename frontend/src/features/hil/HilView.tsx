import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { FmsReadouts } from "../../readouts/FmsReadouts";
import {
  coordinate,
  degreesPerSecond,
  heading,
  hundredths,
  tenths,
  thousandths,
} from "../../readouts/formats";
import { type FieldProps, LiveReadout } from "../../readouts/LiveReadout";
import { LiveServoBar } from "../../readouts/LiveServoBar";
import { StreamPanel } from "../../readouts/StreamPanel";
import { ReadoutGrid } from "../../ui/Readout";
import "./hil.css";

/** "HIL": what the simulator says, what the board answers, and the plan that it flies there. */
export function HilView() {
  const { t } = useTranslation();
  return (
    <div className="hil">
      <SimulatorGroups />
      <StreamPanel topic="hil_surfaces" title={t("hil.flyByWire")} className="hil-surfaces">
        <LiveServoBar
          topic="hil_surfaces"
          field="elevator"
          label={t("control.elevator")}
          orientation="horizontal"
        />
        <LiveServoBar
          topic="hil_surfaces"
          field="aileron"
          label={t("control.aileron")}
          orientation="horizontal"
        />
        <LiveServoBar
          topic="hil_surfaces"
          field="rudder"
          label={t("control.rudder")}
          orientation="horizontal"
        />
        <LiveServoBar
          topic="hil_surfaces"
          field="throttle"
          label={t("control.throttle")}
          kind="throttle"
          orientation="horizontal"
        />
      </StreamPanel>
      <StreamPanel topic="fms_hil_plan" title={t("hil.fms")} className="hil-fms">
        <FmsReadouts topic="fms_hil_plan" columns={3} />
      </StreamPanel>
    </div>
  );
}

/** The six groups of the simulator's rows. */
function SimulatorGroups() {
  const { t } = useTranslation();
  const deg = t("unit.deg");
  const rate = t("unit.degPerS");
  return (
    <>
      <Group title={t("hil.ahrs")} className="hil-ahrs">
        <Value
          field="true_heading_deg"
          format={heading}
          label={t("attitude.heading")}
          unit={deg}
          size="large"
        />
        <Value field="pitch_deg" format={tenths} label={t("attitude.pitch")} unit={deg} size="large" />
        <Value field="roll_deg" format={tenths} label={t("attitude.roll")} unit={deg} size="large" />
      </Group>
      <Group title={t("hil.ads")} className="hil-ads">
        <Value
          field="indicated_airspeed_kt"
          quantity="speed"
          label={t("hil.airspeed")}
          unit={t("unit.kias")}
          size="large"
        />
        <Value field="altitude_indicated_ft" quantity="altitude" label={t("hil.altitude")} size="large" />
      </Group>
      <Group title={t("hil.gps")} className="hil-gps">
        <Value field="latitude_deg" format={coordinate} label={t("gps.latitude")} unit={deg} chars={10} />
        <Value field="longitude_deg" format={coordinate} label={t("gps.longitude")} unit={deg} chars={10} />
        <Value field="altitude_msl_ft" quantity="altitude" label={t("gps.altitude")} />
      </Group>
      <Group title={t("hil.gyros")} className="hil-gyros">
        <Value field="q_rad_s" format={degreesPerSecond} label={t("axis.q")} unit={rate} />
        <Value field="p_rad_s" format={degreesPerSecond} label={t("axis.p")} unit={rate} />
        <Value field="r_rad_s" format={degreesPerSecond} label={t("axis.r")} unit={rate} />
      </Group>
      <Group title={t("hil.paths")} className="hil-paths">
        <Value field="alpha_deg" format={hundredths} label={t("hil.alpha")} unit={deg} />
        <Value field="beta_deg" format={hundredths} label={t("hil.beta")} unit={deg} />
        <Value field="horizontal_path_deg" format={heading} label={t("hil.horizontalPath")} unit={deg} />
        <Value field="vertical_path_deg" format={hundredths} label={t("hil.verticalPath")} unit={deg} />
      </Group>
      <Group title={t("hil.loads")} className="hil-loads">
        <Value field="mach" format={thousandths} label={t("hil.mach")} />
        <Value field="vvi_ft_min" quantity="verticalSpeed" label={t("hil.vvi")} />
        <Value field="g_normal" format={hundredths} label={t("hil.gNormal")} unit={t("unit.g")} />
        <Value field="g_axial" format={hundredths} label={t("hil.gAxial")} unit={t("unit.g")} />
        <Value field="g_side" format={hundredths} label={t("hil.gSide")} unit={t("unit.g")} />
      </Group>
    </>
  );
}

function Group({ title, className, children }: { title: string; className: string; children: ReactNode }) {
  return (
    <StreamPanel topic="simulator" title={title} className={className}>
      <ReadoutGrid>{children}</ReadoutGrid>
    </StreamPanel>
  );
}

function Value(props: FieldProps<"simulator">) {
  return <LiveReadout topic="simulator" {...props} />;
}
