import { expect, type Page } from "@playwright/test";

/** The groups of main tabs as they stand, with the tabs of each; a group of one tab has its name. */
export const GROUPS = {
  es: {
    Vuelo: ["Vista de vuelo", "Datos de vuelo", "Standard Six"],
    Planes: ["Planes de vuelo", "Mapa 3D"],
    "Autopilot Param": ["Autopilot Param"],
    HIL: ["HIL", "HIL Standard Six", "AHRS 3D"],
    Vuelos: ["Vuelos", "Gráficas"],
    "Mensajes y alarmas": ["Mensajes", "Alarmas"],
    Setup: ["Setup"],
  },
  en: {
    Fly: ["Flight view", "Flight data", "Standard Six"],
    Plans: ["Flight plans", "3D map"],
    "Autopilot Param": ["Autopilot Param"],
    HIL: ["HIL", "HIL Standard Six", "AHRS 3D"],
    Flights: ["Flights", "Plots"],
    "Messages and alarms": ["Messages", "Alarms"],
    Setup: ["Setup"],
  },
} as const;

/** Every main tab, in the order of the groups. */
export const TABS: readonly string[] = Object.values(GROUPS.es).flat();

/** Open a main tab by its name in either language, as one does in a window of any size. */
export async function openTab(page: Page, name: string): Promise<void> {
  const groups = [...Object.entries(GROUPS.es), ...Object.entries(GROUPS.en)];
  const [group, tabs] = groups.find(([, names]) => names.some((one) => one === name)) ?? [];
  if (group === undefined || tabs === undefined) throw new Error(`no main tab is called ${name}`);
  const inBar = page
    .getByRole("tablist", { name: /^(Pestañas principales|Main tabs)$/ })
    .getByRole("tab", { name: group, exact: true });
  if ((await inBar.getAttribute("aria-selected")) !== "true") await inBar.click();
  const panel = page.getByRole("tabpanel", { name, exact: true }).first();
  if (tabs.length > 1 && (await inBar.getAttribute("aria-haspopup")) === null) {
    const row = page.getByRole("tablist", { name: /^(Pestañas de|Tabs of) / });
    await row.getByRole("tab", { name, exact: true }).click();
  } else if (!(await panel.isVisible())) {
    await inBar.click();
    await page.getByRole("menuitemradio", { name, exact: true }).click();
  }
  await expect(panel).toBeVisible();
}
