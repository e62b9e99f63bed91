import { attitude, expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";

test("the board's line is pulled: everything goes stale and the alarm shows; plugged in, it recovers", {
  tag: "@refused",
}, async ({ page, flying }) => {
  await open(page, flying);
  await expect(attitude(page)).toHaveAttribute("data-state", "live");

  await flying.line.pull();
  const alarms = page.getByRole("region", { name: "Alarmas" });
  await expect(alarms.getByRole("alert")).toContainText("Se ha perdido el latido de la placa");
  await expect(attitude(page)).not.toHaveAttribute("data-state", "live");
  await expect(page.getByRole("img", { name: "Indicador de rumbo" })).not.toHaveAttribute("data-state", "live");
  const panel = page.getByRole("tabpanel", { name: "Datos de vuelo", exact: true });
  await expect(panel.getByText("en vivo")).toHaveCount(0);
  await expect(page.getByRole("contentinfo")).toContainText("perdido");
  // A command cannot be given, and says why; Autopilot Off can be asked for all the same, and is answered.
  const autopilot = page.getByRole("group", { name: "Autopilot" });
  const last = page.getByRole("status", { name: "Último mensaje" });
  await expect(autopilot.getByRole("radio", { name: "On" })).toBeDisabled();
  await autopilot.getByText("On", { exact: true }).click({ force: true });
  await expect(last).toContainText("No se ha hecho nada. No hay enlace con la placa.");
  await autopilot.getByText("Off", { exact: true }).click();
  await expect(last).toContainText("no hay ninguna placa conectada");
  for (const tab of ["HIL", "Setup"]) {
    await openTab(page, tab);
    await expect(alarms.getByRole("alert")).toContainText("Se ha perdido el latido de la placa");
  }

  await flying.line.plugIn();
  await expect(attitude(page)).toHaveAttribute("data-state", "live");
  await expect(alarms.getByRole("alert")).not.toContainText("latido");
  await expect(page.getByRole("contentinfo")).toContainText("conectado");
  // Nobody acknowledged it: that it was there stays in sight until somebody does.
  await expect(alarms.getByRole("listitem").filter({ hasText: "latido perdido" })).toBeVisible();
  await alarms.getByRole("button", { name: "Reconocer que terminó: latido perdido" }).click();
  await expect(alarms.getByRole("listitem").filter({ hasText: "latido perdido" })).toHaveCount(0);
  // The board never stopped flying, and flies on under the station.
  await expect.poll(async () => await flying.value("heartbeat", "autopilot_hil")).toBe(true);
});

test("the gateway is killed in flight: the page says so, and both carry on by themselves", {
  tag: "@gateway-away",
}, async ({ page, flying }) => {
  await open(page, flying);
  await expect(attitude(page)).toHaveAttribute("data-state", "live");

  await flying.killGateway();
  const alarms = page.getByRole("region", { name: "Alarmas" }).getByRole("alert");
  await expect(alarms).toContainText("No hay conexión con la estación");
  await expect(attitude(page)).not.toHaveAttribute("data-state", "live");

  await flying.restartGateway();
  await expect(attitude(page)).toHaveAttribute("data-state", "live");
  await expect(alarms).not.toContainText("No hay conexión");
  // What the page had not fetched yet when the gateway died, it fetches now.
  const panel = page.getByRole("tabpanel", { name: "Datos de vuelo", exact: true });
  await expect(panel.getByRole("button", { name: "Reintentar" })).toHaveCount(0);
  await expect(panel.getByText("en vivo").first()).toBeVisible();
  await expect.poll(async () => (await flying.status()).simulator.hil_round_trip_ms.newest).not.toBeNull();
  expect((await flying.status()).hil).toMatchObject({ source: "joystick", path: "assisted" });
});
