import type { Browser, Page } from "@playwright/test";
import { attitude, expect, open, test } from "../support/fixtures.js";
import { Network } from "../support/network.js";
import { openTab } from "../support/tabs.js";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** A browser of its own, with cookies of its own, whose page is opened with this one-time key. */
async function enter(browser: Browser, address: string, name: string, options: object = {}): Promise<Page> {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  await page.goto(address, { waitUntil: "domcontentloaded" });
  await page.getByRole("textbox", { name: "Tu nombre" }).fill(name);
  await page.getByRole("button", { name: "Entrar", exact: true }).click();
  return page;
}

/** Where cookies are blocked the page says so, and the invitation is still good afterwards. */
async function expectNothingSpentWithoutCookies(browser: Browser, invitation: string): Promise<void> {
  const context = await browser.newContext(PHONE);
  const page = await context.newPage();
  const tools = await context.newCDPSession(page);
  await tools.send("Emulation.setDocumentCookieDisabled", { disabled: true });
  await page.goto(invitation, { waitUntil: "domcontentloaded" });
  await page.getByRole("textbox", { name: "Tu nombre" }).fill("Ana");
  await expect(page.getByRole("status").getByText(/no guarda cookies/)).toBeVisible();
  await expect(page.getByRole("button", { name: "Entrar", exact: true })).toBeDisabled();
  await context.close();
}

function mine(page: Page) {
  return page.getByText("Tienes el control", { exact: true });
}

test.describe("a station that trusts nobody without a key", () => {
  test.use({ trustsThisComputer: false });

  test("a phone joins by an invitation, asks for control, gets it, loses it with its network, and is put out", async ({
    browser,
    station,
  }) => {
    const network = await Network.to(station.url);
    const laptop = await enter(browser, `${station.url}/#key=${await station.invite("owner")}`, "Luis");
    await expect(mine(laptop)).toBeVisible();

    const invitation = `${network.url}/#key=${await station.invite("operator")}&tab=six`;
    await expectNothingSpentWithoutCookies(browser, invitation);
    const phone = await enter(browser, invitation, "Ana", PHONE);
    const six = phone.getByRole("tabpanel", { name: "Standard Six", exact: true });
    await expect(six).toBeVisible();
    expect(phone.url(), "the key has left the address bar").toBe(`${network.url}/#tab=six`);
    await expect(phone.getByText("El control lo tiene Luis · portátil", { exact: true })).toBeVisible();

    // Whoever flies keeps the keyboard while somebody asks.
    await laptop.getByRole("tab", { name: "Setup", exact: true }).focus();
    await phone.getByRole("button", { name: "Pedir el control" }).tap();
    const band = laptop.getByRole("status", { name: "Peticiones de control" });
    await expect(band).toContainText("Ana · teléfono pide el control.");
    await expect(laptop.getByRole("tab", { name: "Setup", exact: true })).toBeFocused();
    await band.getByRole("button", { name: "Dárselo" }).click();
    await expect(mine(phone)).toBeVisible();

    network.cut();
    await expect(laptop.getByText("Nadie tiene el control", { exact: true })).toBeVisible();
    await expect(
      laptop.getByText("Se ha perdido a Ana · teléfono: nadie tiene el control.", { exact: true }),
    ).toBeVisible();
    network.mend();
    // Who lost it has it back on returning, while nobody else wanted it.
    await expect(mine(phone)).toBeVisible();

    await laptop.getByRole("button", { name: "Tomarlo ya" }).click();
    await laptop.getByRole("alertdialog").getByRole("button", { name: "Tomar el control" }).click();
    await expect(mine(laptop)).toBeVisible();
    await expect(phone.getByText("El control lo tiene Luis · portátil", { exact: true })).toBeVisible();

    await openTab(laptop, "Setup");
    const access = laptop.getByRole("region", { name: "Acceso", exact: true });
    await access.getByRole("combobox", { name: "Papel de Ana · teléfono" }).selectOption("viewer");
    await expect(phone.getByRole("button", { name: "Pedir el control" })).toBeDisabled();
    await access.getByRole("button", { name: "Terminar el acceso de Ana · teléfono" }).click();
    await laptop.getByRole("alertdialog").getByRole("button", { name: "Terminar" }).click();
    await expect(phone.getByText(/Tu acceso ha terminado/)).toBeVisible();
    await expect(six).toHaveCount(0);

    await phone.getByRole("button", { name: "Pedir entrar" }).tap();
    await access
      .getByRole("region", { name: "Piden entrar" })
      .getByRole("button", { name: "Dejar entrar", exact: true })
      .click();
    await expect(six).toBeVisible();
    await expect(phone.getByRole("button", { name: "Pedir el control" })).toBeDisabled();

    await access.getByRole("tab", { name: "Registro" }).click();
    await expect(access.getByRole("row", { name: /Luis · portátil.*Ana/ }).first()).toBeVisible();
    await network.close();
  });
});

test("an installed page starts while the station is away, says so, and shows no value", {
  tag: "@gateway-away",
}, async ({ page, context, flying }) => {
  await open(page, flying);
  await expect(attitude(page)).toHaveAttribute("data-state", "live");
  await page.evaluate(async () => {
    const { active } = await navigator.serviceWorker.ready;
    if (active === null || active.state === "activated") return;
    await new Promise((done) => active.addEventListener("statechange", done, { once: true }));
  });
  const kept = await page.evaluate(async () => {
    const names = await caches.keys();
    const requests = await Promise.all(names.map(async (name) => await (await caches.open(name)).keys()));
    return requests.flat().map(({ url }) => new URL(url).pathname);
  });
  expect(kept).toContain("/");
  expect(kept.filter((path) => path !== "/" && !path.startsWith("/assets/"))).toEqual([]);

  await flying.killGateway();
  const later = await context.newPage();
  await later.goto(flying.url, { waitUntil: "domcontentloaded" });
  await expect(later.getByRole("heading", { name: "EPF GCS" })).toBeVisible();
  await expect(later.getByText("Control desconocido")).toBeVisible();
  await expect(attitude(later)).toHaveAttribute("data-state", "none");
});
