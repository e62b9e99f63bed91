import { expect, open, test } from "../support/fixtures.js";
import { Gamepad } from "../support/gamepad.js";
import { openTab } from "../support/tabs.js";

test("a pilot flies with a gamepad at the browser, and a gamepad that is pulled out leaves no hand on the stick", async ({
  page,
  flying,
}) => {
  const told = async () => {
    const stick = ["elevator", "aileron", "rudder", "throttle"];
    return await Promise.all(stick.map(async (axis) => Number((await flying.value("xplane_info", axis)).toFixed(2))));
  };
  const gamepad = await Gamepad.at(page);
  await open(page, flying);
  await openTab(page, "Setup");
  const panel = page.getByRole("region", { name: "Palanca del piloto" });
  const controls = page.getByRole("region", { name: "Controles" });
  const browser = panel.getByRole("radio", { name: "Mando de este navegador" });
  await expect(browser).toBeDisabled();

  await gamepad.hold(0, 0, 0, 0);
  await expect(panel.getByRole("combobox", { name: "Mando" })).toContainText("Journey Pad");
  await expect(panel).toContainText("Esperando ejes: Elevator, Aileron, Rudder, Throttle.");
  await gamepad.hold(0.5, 0.5, 0.5, 0.5);
  await expect(panel).not.toContainText("Esperando ejes");
  await gamepad.hold(0, 0, 0, 0);
  await panel.getByText("Mando de este navegador", { exact: true }).click();
  await expect(browser).toBeChecked();
  await expect(controls).toContainText("Mando");
  // Pulled back to the right with full throttle and left rudder, through the dead zone of a tenth.
  await gamepad.hold(-0.55, -1, 0.55, 1);
  await expect(controls).toContainText("-0.50");
  await expect.poll(told, "what the board is told").toEqual([1, 0.5, -0.5, 1]);

  // By hand straight to the simulator: its own surfaces come back in its rows.
  await page.getByRole("group", { name: "X-Plane" }).getByText("Manual").click();
  await page.getByRole("button", { name: "Llevar a mano" }).click();
  await expect.poll(async () => await flying.surfaces(), "what the simulator moves").toEqual([1, 0.5, -0.5]);

  await gamepad.unplug();
  await expect(
    page.getByRole("alert").filter({ hasText: "No llega nada del mando Journey Pad" }).first(),
  ).toBeVisible();
  await expect(controls).toContainText("Sin mando");
  await expect(controls).not.toContainText("0.50");
  await expect.poll(told, "a stick that is let go, and no power").toEqual([0, 0, 0, 0]);
  await expect.poll(async () => await flying.surfaces(), "what the simulator moves").toEqual([0, 0, 0]);

  await gamepad.hold(0, -0.55, 0, 0);
  await expect(panel).toContainText("Esperando ejes: Elevator, Aileron, Rudder, Throttle.");
  expect(await told(), "nobody knows yet where its axes stand").toEqual([0, 0, 0, 0]);
  await panel.getByRole("button", { name: "Las barras son correctas" }).click();
  await expect.poll(told, "it counts again").toEqual([0, 0, 0, 0.5]);
  await page.getByRole("button", { name: "Soltar" }).click();
  await expect
    .poll(async () => (await flying.status()).hil.stick.source, "no gamepad without control")
    .toBe("simulator");
});
