import { act, screen, within } from "@testing-library/react";
import { expect, test } from "vitest";
import { AS_SENT, chooseUnit } from "../store/chosenUnits";
import { Station } from "../test/station";
import { Tab } from "../test/tab";

function reading(panel: string, name: string): string {
  const row = within(screen.getByRole("region", { name: panel })).getByText(name).parentElement;
  return [".ui-readout-number", ".ui-readout-unit"]
    .map((part) => row?.querySelector(part)?.textContent ?? "")
    .join(" ");
}

function flying(): Station {
  const station = new Station(<Tab name="flight" />);
  station.greet();
  station.send({
    heartbeat: { analog: true },
    analog: { altitude_m: 304.8, temperature_degc: -40, calibrated_airspeed_kt: 100 },
  });
  return station;
}

test("a quantity has its usual unit until another is chosen, whatever the board sends", () => {
  const station = flying();
  expect(reading("Analog", "Altura")).toBe("1000 ft");
  act(() => chooseUnit(station.page.settings, "altitude", AS_SENT));
  station.show();
  expect(reading("Analog", "Altura")).toBe("304.8 m");
  expect(reading("Analog", "Speed")).toBe("100.0 kt");
});

test("each quantity changes its unit by itself, number and word together", () => {
  const station = flying();
  act(() => chooseUnit(station.page.settings, "altitude", "ft"));
  station.show();
  expect(reading("Analog", "Altura")).toBe("1000 ft");
  expect(reading("Analog", "Speed")).toBe("100.0 kt");
  act(() => chooseUnit(station.page.settings, "temperature", "degF"));
  station.show();
  expect(reading("Analog", "Temp")).toBe("-40.0 °F");
  act(() => chooseUnit(station.page.settings, "speed", "kmPerH"));
  station.show();
  expect(reading("Analog", "Speed")).toBe("185.2 km/h");
});
