import { expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";

test("the autopilot is switched off and on, each time with the board's proof", async ({ page, flying }) => {
  await open(page, flying);
  const autopilot = page.getByRole("group", { name: "Autopilot" });
  const picture = page.getByRole("img", { name: "Camino de la señal de control" });
  await expect(autopilot.getByRole("radio", { name: "On" })).toBeChecked();

  await autopilot.getByText("Off", { exact: true }).click();
  await expect(page.getByRole("status", { name: "Último mensaje" })).toContainText(/Autopilot Off: confirmado/);
  await expect(autopilot.getByRole("radio", { name: "Off" })).toBeChecked();
  expect((await flying.status()).hil).toMatchObject({ source: "joystick", path: "assisted" });
  await expect.poll(async () => await flying.value("heartbeat", "autopilot_hil")).toBe(false);
  await expect(picture).not.toContainText("ignorado");

  await autopilot.getByText("On", { exact: true }).click();
  await expect(page.getByRole("status", { name: "Último mensaje" })).toContainText(/Autopilot On: confirmado/);
  await expect.poll(async () => await flying.value("heartbeat", "autopilot_hil")).toBe(true);
  await expect(picture).toContainText("ignorado");
});

test("both switches move the way of the signal, by keyboard alone", async ({ page, flying }) => {
  await open(page, flying);
  const path = page.getByRole("group", { name: "X-Plane" });
  await expect(path.getByRole("radio", { name: "Ordenador de a bordo" })).toBeChecked();
  await path.getByRole("radio", { name: "Ordenador de a bordo" }).focus();
  await page.keyboard.press("ArrowLeft");
  // The autopilot flies: by hand only after a question, whose safe answer has the focus.
  await expect(page.getByRole("alertdialog", { name: "¿Llevar X-Plane a mano?" })).toBeVisible();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await expect.poll(async () => (await flying.status()).hil.path).toBe("manual");
  await expect(path.getByRole("radio", { name: "Manual" })).toBeChecked();
  const source = page.getByRole("group", { name: "Fuente" });
  await source.getByRole("radio", { name: "Joystick" }).focus();
  await page.keyboard.press("ArrowRight");
  await expect.poll(async () => (await flying.status()).hil.source).toBe("rc");
  await expect.poll(async () => await flying.value("heartbeat", "source_joystick")).toBe(false);
  // Arrow keys go on from the position that the page shows.
  await expect(source.getByRole("radio", { name: "RC" })).toBeChecked();

  // A transmitter that is switched off leaves both off; the page says so on the way back, and offers to undo it.
  await source.getByRole("radio", { name: "RC" }).focus();
  await page.keyboard.press("ArrowLeft");
  const leftOff = page.getByRole("status", { name: "Tras RC" });
  await expect(leftOff).toContainText("siguen quitados: Autopilot, Autotrim.");
  await leftOff.getByRole("button", { name: "Autopilot On" }).press("Enter");
  await expect(leftOff).toContainText("siguen quitados: Autotrim.");
  await leftOff.getByRole("button", { name: "Autotrim On" }).press("Enter");
  await expect(leftOff).toBeEmpty();
  await expect.poll(async () => await flying.value("heartbeat", "autopilot_hil")).toBe(true);
});

test("looking at every tab sends the board nothing but the simulator's information", async ({ page, flying }) => {
  await open(page, flying);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
  flying.line.forget();
  for (const name of ["HIL", "Setup", "Datos de vuelo"]) {
    await openTab(page, name);
    await expect(page.getByRole("tabpanel", { name, exact: true })).toBeVisible();
  }
  for (const name of ["GPS status", "Uso de la CPU", "Fast GPS", "GPS", "ServosIn", "Fly-by-wire", "FMS"]) {
    await page.getByRole("tab", { name, exact: true }).click();
    await expect(page.getByRole("tabpanel", { name, exact: true })).toBeVisible();
  }
  // Frames of the captured station: `#QT,`, type 50, 15 values, checksum, end.
  const frames = flying.line.sentBytes.toString("latin1").split("#QT,").slice(1, -1);
  expect(frames.length).toBeGreaterThan(0);
  for (const frame of frames) expect(Buffer.from(frame, "latin1").readInt32LE(0)).toBe(50);
});
