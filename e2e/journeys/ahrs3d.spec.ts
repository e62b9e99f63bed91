import type { Page } from "@playwright/test";
import { attitude, expect, open, test } from "../support/fixtures.js";
import { closeMenu, openMenu } from "../support/menu.js";
import { openTab } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";

/** The aircraft in 3D, which tells in attributes how its model is turned. */
function aircraft(page: Page) {
  return page.getByRole("application", { name: "Avión en 3D" });
}

async function openAircraft(page: Page): Promise<void> {
  await openTab(page, "AHRS 3D");
  await expect(aircraft(page)).toHaveAttribute("data-has-picture", "true");
}

/** Pitch and roll of the model and of the horizon beside it, read in one moment. */
async function farthestFromHorizon(page: Page): Promise<number> {
  return await page.evaluate(() => {
    const read = (selector: string): number[] => {
      const element = document.querySelector<HTMLElement>(selector);
      return [element?.dataset.pitchDeg, element?.dataset.rollDeg].map((text) => Number(text ?? Number.NaN));
    };
    const horizon = read('[role="img"][data-pitch-deg][data-roll-deg]');
    return Math.max(...read(".ahrs3d-host").map((angle, index) => Math.abs(angle - (horizon[index] ?? Number.NaN))));
  });
}

test("the aircraft is turned as the horizon beside it, is aligned, and goes grey with its stream", {
  tag: ANY_STATION,
}, async ({ page, flying }) => {
  await open(page, flying);
  await openAircraft(page);
  await expect(aircraft(page)).toHaveAttribute("data-state", "live");
  await expect(attitude(page)).toHaveAttribute("data-state", "live");
  await expect.poll(async () => await farthestFromHorizon(page)).toBeLessThan(1);
  await expect
    .poll(async () => {
      const shown = Number(await aircraft(page).getAttribute("data-yaw-deg"));
      const told = await flying.value("ahrs", "yaw_deg");
      return Math.abs(((shown - told + 540) % 360) - 180);
    })
    .toBeLessThan(2);

  await page.getByRole("button", { name: "Alinear", exact: true }).click();
  await expect(page.getByText(/El rumbo .*° es el cero/)).toBeVisible();
  await expect
    .poll(async () => {
      const shown = Number(await aircraft(page).getAttribute("data-yaw-deg"));
      return Math.abs(((shown + 540) % 360) - 180);
    })
    .toBeLessThan(10);
  await page.getByRole("button", { name: "Quitar alineación" }).click();
  await expect(page.getByText(/es el cero/)).toHaveCount(0);

  // In flight the board is not left to the test.
  await expect(page.getByRole("button", { name: "Empezar la prueba AHRS" })).toHaveAccessibleDescription(/volando/);

  await openMenu(page, "Parámetros");
  await page.getByRole("menu").getByRole("menuitemcheckbox", { name: "AHRS", exact: true }).click();
  await closeMenu(page);
  await expect(aircraft(page)).toHaveAttribute("data-state", "stale");
  await expect(aircraft(page)).not.toHaveAttribute("data-pitch-deg");
  await expect(page.getByText(/DATO ANTIGUO/)).toBeVisible();
});

test("on the ground the AHRS test turns the aircraft, and the board's frames are back after it", async ({
  page,
  station,
}) => {
  await station.openBoard();
  await station.command("start");
  await open(page, station);
  await openAircraft(page);
  await expect(aircraft(page)).toHaveAttribute("data-state", "live");

  await page.getByRole("button", { name: "Empezar la prueba AHRS" }).click();
  await page.getByRole("alertdialog").getByRole("button", { name: "Empezar", exact: true }).click();
  await expect(page.getByText(/Prueba AHRS en marcha/)).toBeVisible();
  await expect(aircraft(page)).toHaveAttribute("data-state", "live");
  // Everything else is silent, and says so.
  await expect(attitude(page)).not.toHaveAttribute("data-state", "live");
  await expect(page.getByRole("region", { name: "Alarmas" }).getByRole("alert")).not.toContainText("latido");

  await page.getByRole("button", { name: "Terminar la prueba", exact: true }).click();
  await expect(page.getByText(/Prueba AHRS en marcha/)).toHaveCount(0);
  await expect(attitude(page)).toHaveAttribute("data-state", "live");
  await expect(aircraft(page)).toHaveAttribute("data-state", "live");
});
