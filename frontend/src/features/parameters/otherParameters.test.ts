import { describe, expect, test } from "vitest";
import { PARAMETERS } from "../../protocol/messages.gen";
import { readParameterFile } from "./parameterFile";

const QGC = [
  "# Onboard parameters for Vehicle 1",
  "#",
  "# Vehicle-Id Component-Id Name Value Type",
  "1\t1\tRLL2SRV_TCONST\t0.500000000000000000\t9",
  "1\t1\tk_roll\t2.750000000000000000\t9",
  "1\t1\tWP_RADIUS\t90\t4",
  "",
].join("\r\n");

describe("a .params file of QGroundControl", () => {
  test("gives the gains that exist here, and says which of its parameters do not", () => {
    const file = readParameterFile(QGC, PARAMETERS);
    expect(file).toMatchObject({
      lines: [{ name: "k_roll", value: 2.75, fault: null }],
      leftOut: ["RLL2SRV_TCONST", "WP_RADIUS"],
    });
  });

  test("without any of them is refused: nothing of it is meant for this board", () => {
    expect(readParameterFile(QGC.replace("k_roll", "RLL_P"), PARAMETERS)).toBe("nothing_here");
  });

  test.each([
    ["k_roll,500", "out_of_range"],
    ["k_roll,1.2.3", "not_a_number"],
    ["k_div_velocidad,700.5", "not_whole"],
  ])("with %s says what is wrong with it", (line, fault) => {
    expect(readParameterFile(`${line}\nWP_RADIUS,90`, PARAMETERS)).toMatchObject({ lines: [{ fault }] });
  });

  test("that is cut or of another kind is refused whole", () => {
    expect(readParameterFile("1\t1\tk_roll\n", PARAMETERS)).toBe("not_json");
    expect(readParameterFile("k_roll,2\n<html>", PARAMETERS)).toBe("not_json");
    expect(readParameterFile("", PARAMETERS)).toBe("not_json");
  });
});
