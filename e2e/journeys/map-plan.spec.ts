import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import type { Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { partOf, pixelsOf } from "../support/pixels.js";
import type { Station } from "../support/station.js";
import { openTab } from "../support/tabs.js";

/** The route Gando begins again after its last. */
const GANDO_WAYPOINTS = 8;

/** Opens the tab with the map that a person has chosen before. */
async function openMap(page: Page, station: Station, kind: "2d" | "3d"): Promise<void> {
  const settings = JSON.stringify({ language: "es", choices: { "map.kind": kind } });
  await page.addInitScript((chosen) => localStorage.setItem("epf-gcs.settings", chosen), settings);
  await open(page, station);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
  await openTab(page, "Mapa 3D");
  await expect(page.getByRole("button", { name: "Ver todo", exact: true })).toBeEnabled();
}

test("a waypoint is pushed on the map, taken back, pushed again and sent, and the board flies on with it", async ({
  page,
  flying,
}) => {
  // Some way along the route, so that it is seen whether the board starts it again.
  for (let step = 0; step < 3; step += 1) await flying.command("hil_fms_next_waypoint");
  // The panel is the globe's too, and beside the flat map nothing waits for graphics.
  await openMap(page, flying, "2d");
  const panel = page.getByRole("region", { name: "Planes de vuelo", exact: true });
  await panel.getByRole("radio", { name: "Plan HIL", exact: true }).check({ force: true });
  // The board tells the name of the route that it flies: the map knows it without asking.
  await expect(panel).toContainText("igual que en la placa");
  await panel.getByRole("combobox", { name: "Waypoint", exact: true }).selectOption("1");
  const latitude = panel.getByRole("textbox", { name: "Latitud", exact: true });
  await expect(latitude).toHaveValue("27.950300");

  await panel.getByRole("button", { name: "Al norte", exact: true }).focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("PageUp");
  await expect(latitude).toHaveValue("27.950390");
  await expect(panel).toContainText("distinto del de la placa");
  await panel.getByRole("button", { name: "Deshacer", exact: true }).press("Enter");
  await panel.getByRole("button", { name: "Deshacer", exact: true }).press("Enter");
  await expect(panel).toContainText("igual que en la placa");

  await panel.getByRole("button", { name: "Al norte", exact: true }).focus();
  await page.keyboard.press("ArrowUp");
  await panel.getByRole("button", { name: "Enviar", exact: true }).press("Enter");
  // The aircraft flies meanwhile: it goes on to the waypoint that the board tells when it is asked, 4 or a later one.
  await expect(page.getByRole("alertdialog")).toContainText(/La placa vuela al waypoint [4-8]\./);
  const goOn = page.getByRole("button", { name: /^Enviar y seguir al [4-8]$/ });
  const asked = Number((await goOn.textContent())?.match(/\d+/)?.[0]) - 1;
  await goOn.press("Enter");
  await expect(page.getByRole("status", { name: "Último mensaje" })).toContainText(/Ir al waypoint: confirmado/);
  // What the board says from then on: that one or the next after it, never the first again.
  const since_s = (await flying.sample("fms_hil_plan")).t_s;
  await expect.poll(async () => (await flying.sample("fms_hil_plan")).t_s).toBeGreaterThan(since_s + 1);
  const flown = (await flying.sample("fms_hil_plan")).values.waypoint;
  expect([asked, (asked + 1) % GANDO_WAYPOINTS]).toContain(flown);
  const read = await (await fetch(`${flying.url}/api/v1/missions/hil`)).json();
  expect(read.waypoints[1].latitude_deg).toBeCloseTo(27.95039, 6);
});

/** A map file of one red tile that covers the world, made with the standard library of the station's own language. */
const RED_MAP = `
import sqlite3, struct, sys, zlib
def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
rows = (b"\\x00" + b"\\xff\\x00\\x00" * 256) * 256
png = (b"\\x89PNG\\r\\n\\x1a\\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 256, 256, 8, 2, 0, 0, 0))
       + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
file = sqlite3.connect(sys.argv[1])
file.execute("create table metadata (name text, value text)")
file.execute("create table tiles (zoom_level integer, tile_column integer, tile_row integer, tile_data blob)")
file.executemany("insert into metadata values (?, ?)", [
    ("name", "Rojo"), ("format", "png"), ("minzoom", "0"), ("maxzoom", "0"), ("bounds", "-180,-85,180,85"),
    ("attribution", "Nadie")])
file.execute("insert into tiles values (0, 0, 0, ?)", (png,))
file.commit()
`;

test("a map file of the operator's is taken in, stands in the list and is seen on both maps", async ({
  page,
  station,
}) => {
  const folder = mkdtempSync(path.join(tmpdir(), "epf-map-"));
  const file = path.join(folder, "rojo.mbtiles");
  execFileSync("python3", ["-c", RED_MAP, file]);
  await openMap(page, station, "3d");
  const panel = page.getByRole("region", { name: "Capas", exact: true });
  await panel.locator("input[type=file]").setInputFiles(file);
  await expect(panel.getByRole("checkbox", { name: "Rojo" })).toBeChecked();
  await expect(page.getByText(/^Nadie( ·|$)/)).toBeVisible();
  await page.getByRole("button", { name: "Ir a casa", exact: true }).press("Enter");
  // Within what the globe's light makes of it.
  const isRed = (red: number, green: number, blue: number): boolean => red > 120 && green < 70 && blue < 70;
  const redPart = async (canvas: string): Promise<number> => partOf(await pixelsOf(page, page.locator(canvas)), isRed);
  await expect.poll(() => redPart(".map-host .globe-picture")).toBeGreaterThan(0.5);

  await page.getByRole("radio", { name: "Mapa 2D", exact: true }).check({ force: true });
  await expect.poll(() => redPart(".map-flat canvas")).toBeGreaterThan(0.5);
  rmSync(folder, { recursive: true });
});
