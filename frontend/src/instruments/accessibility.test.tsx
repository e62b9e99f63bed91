import { render } from "@testing-library/react";
import axe from "axe-core";
import { expect, test } from "vitest";
import { AirspeedIndicator } from "./airspeed/AirspeedIndicator";
import { Altimeter } from "./altitude/Altimeter";
import { AttitudeIndicator } from "./attitude/AttitudeIndicator";
import { ControlCross } from "./controls/ControlCross";
import { HeadingIndicator } from "./heading/HeadingIndicator";
import { ControlPath } from "./path/ControlPath";
import { ServoBar } from "./servo/ServoBar";
import { VerticalSpeedIndicator } from "./vvi/VerticalSpeedIndicator";

const CARDINALS = { north: "N", east: "E", south: "S", west: "W" };
const LABELS = {
  joystick: "Stick",
  rc: "Radio",
  manual: "Manual",
  assisted: "Assisted",
  computer: "Computer",
  autopilot: "Autopilot",
  surfaces: "Surfaces",
  ignored: "ignored",
  unknown: "unknown",
};
const DIAL = {
  noDataText: "NO DATA",
  caption: "CAPTION",
  unit: "u",
  offScaleText: "OFF SCALE",
  format: String,
};

test("no instrument breaks a rule of accessibility, and no two share an id", async () => {
  const { container } = render(
    <main>
      <h1>Instruments</h1>
      <AttitudeIndicator label="Attitude" noDataText="NO DATA" />
      <AttitudeIndicator label="Attitude of the simulator" noDataText="NO DATA" />
      <HeadingIndicator label="Heading" noDataText="NO DATA" cardinals={CARDINALS} />
      <AirspeedIndicator label="Airspeed" {...DIAL} />
      <Altimeter label="Altitude" {...DIAL} />
      <VerticalSpeedIndicator label="Vertical speed" {...DIAL} />
      <ServoBar label="Rudder" noDataText="NO DATA" format={String} />
      <ControlCross label="Stick" noDataText="NO DATA" />
      <ControlPath
        label="Path"
        description="one sentence"
        labels={LABELS}
        source="rc"
        path="assisted"
        autopilot
      />
    </main>,
  );
  const { violations, passes } = await axe.run(container, {
    rules: { "color-contrast": { enabled: false } },
  });
  expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([]);
  expect(passes.map(({ id }) => id)).toContain("svg-img-alt");
  const ids = [...container.querySelectorAll("[id]")].map(({ id }) => id);
  expect(new Set(ids).size).toBe(ids.length);
});
