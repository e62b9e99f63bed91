import type { Page } from "@playwright/test";
import { bytesOf } from "../checklist/captured.js";
import { type Entry, MENUS, RESET } from "../checklist/menus.js";
import { GAIN_NAMES } from "../checklist/screens.js";
import { expect, open, test } from "../support/fixtures.js";
import { closeMenu, entryOf, openMenu } from "../support/menu.js";
import type { Station } from "../support/station.js";
import { openTab, TABS } from "../support/tabs.js";

/** On a legacy board nothing but what is asked for goes over the line, so the bytes can be compared whole. */

/** Reading back is how a legacy board's parameters are confirmed. */
const READ_BACK = bytesOf("pushButtonAutopilotParamLoad");

interface Desk {
  readonly page: Page;
  readonly station: Station;
}

/**
 * Act, wait until the gateway has answered, and compare what the line carried: exactly these frames in any order, one
 * that was not proven at once may have gone out again.
 */
async function sends({ page, station }: Desk, what: string, wanted: readonly string[], act: () => Promise<void>) {
  station.line.forget();
  const answered = page.waitForResponse(
    (answer) => answer.request().method() !== "GET" && new URL(answer.url()).pathname.startsWith("/api/v1/"),
  );
  await act();
  await answered;
  const frames = () => [...new Set(station.line.sentFrames)].sort();
  const expected = wanted.flatMap((hex) => hex.split(/(?=2351542c)/)).filter((hex) => hex !== "");
  await expect.poll(frames, what).toEqual([...new Set(expected)].sort());
}

/** Type a number and leave it by Enter. */
async function enter(page: Page, name: string, value: number): Promise<void> {
  const field = page.getByRole("textbox", { name, exact: true });
  await field.fill(`${value}`);
  await field.press("Enter");
}

async function everyMenu(desk: Desk): Promise<void> {
  const { page } = desk;
  for (const { name, entries } of MENUS) {
    for (const entry of entries) {
      const [first, second] = entry.sends ?? [];
      if (first === undefined || entry === RESET) continue;
      const what = `${name}: ${entry.name}`;
      await openMenu(page, name);
      if (second !== undefined) {
        // A switch stays open under the pointer: there and back, each with the board's proof.
        await sends(desk, what, [bytesOf(first), bytesOf(second)], async () => {
          for (const checked of [false, true]) {
            const answered = page.waitForResponse(/\/api\/v1\/commands\//);
            await entryOf(page, entry).click();
            await answered;
            await expect(entryOf(page, entry)).toBeChecked({ checked });
          }
        });
        await closeMenu(page);
        continue;
      }
      await sends(desk, what, [bytesOf(first)], () => choose(page, entry));
    }
  }
}

/** Press an entry of the open menu, and say yes where it asks. */
async function choose(page: Page, entry: Entry): Promise<void> {
  await entryOf(page, entry).click();
  if (entry.confirm !== undefined) await page.getByRole("button", { name: entry.confirm, exact: true }).click();
}

async function flightTab(desk: Desk): Promise<void> {
  const { page } = desk;
  await openTab(page, "Datos de vuelo");
  await sends(desk, "Read All", [bytesOf("pushButtonParamReadAll")], async () => {
    await page.getByRole("button", { name: "Read All" }).click();
  });
  await page.getByRole("tab", { name: "FMS", exact: true }).click();
  for (const way of ["Next", "Previous"]) {
    await sends(desk, `FMS ${way}`, [bytesOf(`pushButtonFMS${way}`)], async () => {
      await page.getByRole("tabpanel", { name: "FMS", exact: true }).getByRole("button", { name: way }).click();
    });
  }
  await page.getByRole("tab", { name: "Refresco", exact: true }).click();
  for (const [name, action] of [
    ["Parámetros", "spinBoxRateParam"],
    ["FMS", "spinBoxRateFMS"],
    ["Servos", "spinBoxRateServos"],
  ] as const) {
    await sends(desk, `Refresco ${name}`, [bytesOf(action, 60)], () => enter(page, name, 60));
  }
  await page.getByRole("tab", { name: "ServosOut", exact: true }).click();
  for (let servo = 1; servo <= 20; servo += 1) {
    // The captured slider's first step down from the middle.
    await sends(desk, `Servo ${servo}`, [bytesOf(`ServosOut_${servo}`, 1)], async () => {
      await page.getByRole("slider", { name: `Servo ${servo}`, exact: true }).press("ArrowDown");
    });
  }
}

async function hilTab(desk: Desk): Promise<void> {
  const { page } = desk;
  await openTab(page, "HIL");
  for (const way of ["Next", "Previous"]) {
    await sends(desk, `HIL ${way}`, [bytesOf(`pushButtonHILFMS${way}`)], async () => {
      await page
        .getByRole("region", { name: "Parámetros del Flight Management System" })
        .getByRole("button", { name: way })
        .click();
    });
  }
}

async function gains(desk: Desk): Promise<void> {
  const { page, station } = desk;
  await openTab(page, "Autopilot Param");
  // A load only reads: one command, and no value goes back.
  await sends(desk, "Load", [READ_BACK], async () => {
    await page.getByRole("button", { name: "Load", exact: true }).click();
  });
  for (const name of GAIN_NAMES) {
    const [action, value] = name === "k_div_velocidad" ? [`spinBox_${name}`, 710] : [`doubleSpinBox_${name}`, 12.5];
    await sends(desk, name, [bytesOf(action, value), READ_BACK], () => enter(page, name, value));
  }
  // Digit by digit is not command by command.
  station.line.forget();
  await page.getByRole("textbox", { name: "k_elev", exact: true }).pressSequentially("9");
  await page.keyboard.press("Escape");
  expect(station.line.sentFrames).toEqual([]);
}

async function rawLine(desk: Desk): Promise<void> {
  const { page } = desk;
  await openTab(page, "Setup");
  await sends(desk, "raw line", [bytesOf("pushButtonSerialSend")], async () => {
    await page.getByRole("textbox", { name: "Línea para la placa" }).fill("hil load gando");
    await page.getByRole("button", { name: "Enviar" }).click();
  });
}

async function toolbars(desk: Desk): Promise<void> {
  for (const [group, name, action] of [
    // A board starts with RC; with RC as source the transmitter's own switches decide, and the autopilot's are off.
    ["Fuente", "Joystick", "actionPlane_Joystick"],
    ["Fuente", "RC", "actionPlane_RC"],
    ["Fuente", "Joystick", "actionPlane_Joystick"],
    ["Autopilot", "On", "actionAutopilot_On"],
    ["Autopilot", "Off", "actionAutopilot_off"],
    ["Autotrim", "On", "actionAutotrim_On"],
    ["Autotrim", "Off", "actionAutotrim_Off"],
    ["X-Plane", "Ordenador de a bordo", "actionHILControlRC"],
    ["X-Plane", "Manual", "actionHILControlJoystick"],
  ] as const) {
    await sends(desk, `${group}: ${name}`, [bytesOf(action)], async () => {
      await desk.page.getByRole("group", { name: group, exact: true }).getByText(name, { exact: true }).click();
    });
  }
}

test.use({ boardOptions: ["--legacy"] });

test("every control sends exactly the bytes that the captured station sent, and looking sends none", async ({
  page,
  station,
}) => {
  const desk = { page, station };
  await open(page, station);
  await openTab(page, "Setup");
  const board = page.getByRole("region", { name: "Comunicación con el Piloto Automático" });
  await board.getByRole("combobox", { name: "Puerto" }).selectOption("Otra dirección…");
  await board.getByRole("textbox", { name: "Dirección" }).fill(station.boardUrl);
  await board.getByRole("button", { name: "Open" }).click();
  await expect(board).toContainText("clásico");
  expect(station.line.sentBytes.toString("hex").startsWith(bytesOf("pushButtonSerialOpen"))).toBe(true);

  await test.step("looking", async () => {
    station.line.forget();
    for (const tab of TABS) {
      await openTab(page, tab);
      for (const sub of await page.getByRole("tabpanel").getByRole("tab").all()) await sub.click();
    }
    await page.reload({ waitUntil: "domcontentloaded" });
    await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
    expect(station.line.sentFrames).toEqual([]);
  });

  await test.step("toolbars", () => toolbars(desk));
  await test.step("menus", () => everyMenu(desk));
  await test.step("Datos de vuelo", () => flightTab(desk));
  await test.step("HIL", () => hilTab(desk));
  await test.step("Autopilot Param", () => gains(desk));

  await test.step("raw line", () => rawLine(desk));
  await test.step("Reset", async () => {
    await openMenu(page, "Autopilot");
    await sends(desk, "Reset", [bytesOf("actionAutopilotReset")], () => choose(page, RESET));
  });
  await openTab(page, "Setup");
  await board.getByRole("button", { name: "Close" }).click();
  await expect(board).toContainText("cerrado");
  const sent = () => station.line.sentBytes.toString("hex");
  await expect.poll(() => sent().endsWith(bytesOf("pushButtonSerialClose")), "closing").toBe(true);
});
