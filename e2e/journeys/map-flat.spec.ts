import config from "../playwright.config.js";
import { attitude, expect, open, test } from "../support/fixtures.js";
import { middleOf, pixelsOf } from "../support/pixels.js";
import { openTab } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";

// A browser without WebGL, as on a field computer whose graphics driver is missing.
test.use({ launchOptions: { ...config.use?.launchOptions, args: ["--disable-3d-apis"] } });

/** The real aircraft on any map: it lies over the simulator's, which the map follows and which is in the same place. */
const REAL = [255, 217, 26];

test("without WebGL the map says why, and shows the flight from above", { tag: ANY_STATION }, async ({
  page,
  flying,
}) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await open(page, flying);
  await openTab(page, "Mapa 3D");
  await expect(page.getByText(/no ofrece WebGL 2.*En su lugar está el mapa 2D/)).toBeVisible();

  const camera = page.locator(".map-camera");
  await expect(camera.getByText("HIL: en vivo")).toBeVisible();
  await page.getByRole("checkbox", { name: "Retícula de coordenadas" }).uncheck();
  const map = page.getByRole("application", { name: /^Mapa en 2D/ });
  const colour = async (): Promise<readonly number[]> => middleOf(await pixelsOf(page, map.locator("canvas")));
  await expect.poll(colour).toEqual(REAL);

  // Everything but what the globe alone can show is here.
  const plans = page.getByRole("region", { name: "Planes de vuelo", exact: true });
  await expect(plans).toContainText("igual que en la placa");
  await plans.getByRole("combobox", { name: "Waypoint", exact: true }).selectOption("0");
  await expect(page.getByRole("region", { name: "Waypoint 1 · Plan HIL", exact: true })).toBeVisible();
  await page.getByRole("button", { name: "Avión HIL", exact: true }).click();
  await expect(page.getByRole("region", { name: "Avión HIL", exact: true })).toContainText("Latitud");

  // Nor is the globe's engine fetched in vain, and the instruments beside it fly on.
  expect(asked.filter((path) => /cesium|globe-engine/i.test(path))).toEqual([]);
  await expect(attitude(page)).toHaveAttribute("data-state", "live");
  await openTab(page, "AHRS 3D");
  await expect(page.getByText(/WebGL/)).toBeVisible();
});
