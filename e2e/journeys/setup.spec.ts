import { createSocket } from "node:dgram";
import { expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";

test("the operator connects board and simulator from Setup", async ({ page, station }) => {
  await open(page, station);
  await openTab(page, "Setup");
  const board = page.getByRole("region", { name: "Comunicación con el Piloto Automático" });
  await board.getByRole("combobox", { name: "Puerto" }).selectOption("Otra dirección…");
  await board.getByRole("textbox", { name: "Dirección" }).fill(station.boardUrl);
  await board.getByRole("button", { name: "Open" }).click();
  await expect(board).toContainText("conectado");
  await expect(board).toContainText("extendido");

  const simulator = page.getByRole("region", { name: "XPlane" });
  await simulator.getByRole("textbox", { name: "Puerto Tx" }).fill(`${station.simulatorLink.send_port}`);
  await simulator.getByRole("textbox", { name: "Puerto Rx" }).fill(`${station.simulatorLink.receive_port}`);
  await simulator.getByRole("button", { name: "Open" }).click();
  await expect(simulator).toContainText("3, 4, 6, 8, 11, 16, 17, 18, 20, 25");

  await board.getByRole("button", { name: "Close" }).click();
  await expect(board).toContainText("cerrado");
  // Leaving the board means stop and exit, the same bytes that the captured station sends.
  await expect
    .poll(() => station.line.sentBytes.toString("hex"))
    .toContain("2351542c01000000ffffffff0d0a0d0a2351542c31000000cfffffff0d0a0d0a");
});

test("a wrong port and a taken one are each refused in one clear sentence, and nothing else changes", {
  tag: "@refused",
}, async ({ page, station }) => {
  await station.openBoard();
  await open(page, station);
  await openTab(page, "Setup");
  const board = page.getByRole("region", { name: "Comunicación con el Piloto Automático" });
  await board.getByRole("combobox", { name: "Puerto" }).selectOption("Otra dirección…");
  await board.getByRole("textbox", { name: "Dirección" }).fill("/dev/ttyNOT_HERE");
  await board.getByRole("button", { name: "Open" }).click();
  await expect(board.getByRole("alert")).toContainText("/dev/ttyNOT_HERE");
  await expect.poll(async () => (await station.status()).board.url).toBe(station.boardUrl);
  expect((await station.status()).board.state).toBe("open");

  const other = createSocket("udp4");
  await new Promise<void>((resolve) => other.bind(0, "127.0.0.1", resolve));
  const taken = other.address().port;
  const simulator = page.getByRole("region", { name: "XPlane" });
  await simulator.getByRole("textbox", { name: "Puerto Rx" }).fill(`${taken}`);
  await simulator.getByRole("button", { name: "Open" }).click();
  await expect(simulator.getByRole("alert")).toContainText(`${taken}`);
  expect((await station.status()).simulator.state).toBe("closed");
  other.close();
});
