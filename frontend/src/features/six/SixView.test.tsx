import { act, screen } from "@testing-library/react";
import { beforeEach, describe, expect, test } from "vitest";
import { chooseUnit } from "../../store/chosenUnits";
import { Station } from "../../test/station";
import { Tab } from "../../test/tab";

let station: Station;

function open(tab: "six" | "hilSix"): void {
  station = new Station(<Tab name={tab} />);
  station.greet();
}

function dial(name: string): HTMLElement {
  return screen.getByRole("img", { name });
}

function source(title: string): string {
  return screen.getByRole("group", { name: title }).querySelector("dl")?.textContent ?? "";
}

const SIX = [
  "Velocidad",
  "Indicador de actitud",
  "Altímetro barométrico",
  "Altímetro GPS",
  "Indicador de rumbo",
  "Velocidad vertical",
];
const board = {
  heartbeat: { ahrs: true, analog: true, gps: true },
  ahrs: { yaw_deg: -10, pitch_deg: 5, roll_deg: -20 },
  analog: { calibrated_airspeed_kt: 55, altitude_m: 304.8, vvi_ft_min: -700 },
  gps: { altitude_m: 609.6, speed_kt: 61, fix: 1, valid: true },
  fms_plan: { bearing_deg: 42 },
};

describe("Standard Six", () => {
  beforeEach(() => open("six"));

  test("crosses all six out until something is heard", () => {
    expect(SIX.map((name) => dial(name).dataset["state"])).toEqual(Array(6).fill("none"));
  });

  test("drives all six from the board, each named with its source and unit", () => {
    station.send(board);
    expect(SIX.map((name) => dial(name).dataset["state"])).toEqual(Array(6).fill("live"));
    expect(dial("Velocidad").dataset["airspeedKt"]).toBe("55.0");
    expect(dial("Indicador de actitud").dataset).toMatchObject({ pitchDeg: "5.0", rollDeg: "-20.0" });
    expect(dial("Altímetro barométrico").dataset["altitudeFt"]).toBe("1000");
    expect(dial("Altímetro GPS").dataset["altitudeFt"]).toBe("2000");
    expect(dial("Indicador de rumbo").dataset).toMatchObject({ headingDeg: "350.0", bearingDeg: "42.0" });
    expect(dial("Velocidad vertical").dataset["verticalSpeedFtMin"]).toBe("-700");
    expect(source("Velocidad")).toBe("Analog · Speed55.0kt");
    expect(source("Altímetro GPS")).toBe("GPS · Altura2000ft");
  });

  test("crosses an instrument out when its stream stops, and not the others", () => {
    station.send(board);
    for (let tenth = 0; tenth < 14; tenth += 1) {
      station.send({ ahrs: board.ahrs });
    }
    expect(dial("Velocidad").dataset["state"]).toBe("none");
    expect(dial("Indicador de actitud").dataset["state"]).toBe("live");
  });

  test("stops at the end of a scale and says so", () => {
    station.send({ ...board, analog: { ...board.analog, calibrated_airspeed_kt: 200, vvi_ft_min: -2500 } });
    expect(dial("Velocidad").dataset).toMatchObject({ reach: "above", airspeedKt: "200.0" });
    expect(dial("Velocidad vertical").dataset["reach"]).toBe("below");
    expect(dial("Velocidad").textContent).toContain("FUERA DE ESCALA");
  });

  test("shows the GPS's speed when the board flies by it, and says that it does", () => {
    station.send({ ...board, board_status: { airspeed_source: 0 } });
    station.send(board);
    expect(dial("Velocidad").dataset["airspeedKt"]).toBe("61.0");
    expect(source("Velocidad")).toBe("GPS · Speed61.0kt");
    station.send({ ...board, board_status: { airspeed_source: 1 } });
    station.send(board);
    expect(dial("Velocidad").dataset["airspeedKt"]).toBe("55.0");
  });

  test("shows nothing of a receiver that has no fix: it goes on sending what it last knew", () => {
    station.send({ ...board, gps: { ...board.gps, fix: 0 } });
    expect(dial("Altímetro GPS").dataset["state"]).toBe("none");
    station.send({ ...board, gps: { ...board.gps, valid: false } });
    expect(dial("Altímetro GPS").dataset["state"]).toBe("none");
  });

  test("names the plan from which the bug comes", () => {
    station.send(board);
    expect(source("Rumbo")).toContain("FMS · Rumbo42.0°");
    station.send({ ...board, xplane_info: { pitch_deg: 0 }, fms_hil_plan: { bearing_deg: 77 } });
    station.send({ ...board, xplane_info: { pitch_deg: 0 }, fms_hil_plan: { bearing_deg: 77 } });
    expect(dial("Indicador de rumbo").dataset["bearingDeg"]).toBe("77.0");
    expect(source("Rumbo")).toContain("FMS HIL · Rumbo77.0°");
  });

  test("is engraved in the unit that is chosen, and still told in the wire's", () => {
    station.send(board);
    expect(dial("Altímetro barométrico").textContent).toContain("1000");
    act(() => chooseUnit(station.page.settings, "altitude", "m"));
    station.send(board);
    expect(dial("Altímetro barométrico").textContent).toContain("304.8");
    expect(dial("Altímetro barométrico").dataset["altitudeFt"]).toBe("1000");
  });
});

describe("HIL Standard Six", () => {
  test("drives all six from the simulator and the HIL plan, whatever the board says", async () => {
    open("hilSix");
    station.send(board);
    expect(SIX.map((name) => dial(name).dataset["state"])).toEqual(Array(6).fill("none"));
    station.send({
      simulator: {
        indicated_airspeed_kt: 48,
        pitch_deg: -3,
        roll_deg: 7,
        altitude_indicated_ft: 950,
        altitude_msl_ft: 930,
        true_heading_deg: 181,
        vvi_ft_min: 120,
      },
      fms_hil_plan: { bearing_deg: 200 },
    });
    expect(dial("Velocidad").dataset["airspeedKt"]).toBe("48.0");
    expect(dial("Indicador de actitud").dataset).toMatchObject({ pitchDeg: "-3.0", rollDeg: "7.0" });
    expect(dial("Altímetro barométrico").dataset["altitudeFt"]).toBe("950");
    expect(dial("Altímetro GPS").dataset["altitudeFt"]).toBe("930");
    expect(dial("Indicador de rumbo").dataset).toMatchObject({ headingDeg: "181.0", bearingDeg: "200.0" });
    expect(dial("Velocidad vertical").dataset["verticalSpeedFtMin"]).toBe("120");
    expect(source("Velocidad")).toBe("ADS · Vind48.0kias");
  });
});
