import type { CDPSession, Locator, Page } from "@playwright/test";
import { layoutFaults } from "./faults.js";
import { GROUPS, openTab, TABS } from "./tabs.js";

export interface Size {
  readonly width: number;
  readonly height: number;
  /** Fingers, not a mouse. */
  readonly touch?: true;
  /** How far the browser is zoomed, which makes the window this small in CSS pixels. */
  readonly zoom?: number;
}

/** The windows in which the station is used. */
export const SIZES: readonly Size[] = [
  { width: 360, height: 640, touch: true },
  { width: 412, height: 915, touch: true },
  { width: 915, height: 412, touch: true },
  { width: 600, height: 960, touch: true },
  { width: 768, height: 1024, touch: true },
  { width: 1024, height: 768, touch: true },
  { width: 1024, height: 768 },
  { width: 1366, height: 768 },
  { width: 1920, height: 1080 },
  { width: 3840, height: 2160 },
  { width: 683, height: 384, zoom: 2 },
  { width: 320, height: 256, zoom: 4 },
];

export function sizeName({ width, height, touch, zoom }: Size): string {
  return `${width}x${height}${touch ? "-touch" : ""}${zoom === undefined ? "" : `-zoom${zoom * 100}`}`;
}

const VIEW_MENU = 5;
/** Menus by their places, and their entries that open a dialog, in both languages. */
const DIALOGS = [
  [2, /^Reset$/],
  [5, /^(Abrir esta pestaña en una tableta|Open this tab on a tablet)/],
  [5, /^(Registro|Log)$/],
  [5, /^(Lista antes|Checklist before)/],
  [5, /^(Preparar un campo|Prepare a field)/],
  [5, /^(Ajustes|Settings)/],
  [6, /^(Guía|Guide)/],
  [6, /^(Atajos|Keyboard)/],
  [6, /^(Acerca de|About)/],
] as const;

/** The least side of a target: where fingers touch, or the window is so small that it is laid out for them. */
const FINGER_PX = 44;

/** Walks through all that the page can show, in windows of several sizes, without loading it again. */
export class Walk {
  private constructor(
    private readonly page: Page,
    private readonly devtools: CDPSession,
    private size: Size,
    private readonly onScreen: (what: string) => Promise<void>,
  ) {}

  /** `onScreen` is called with each thing that stands on the screen. */
  static async of(page: Page, onScreen: (what: string) => Promise<void> = async () => undefined): Promise<Walk> {
    return new Walk(page, await page.context().newCDPSession(page), { width: 1366, height: 768 }, onScreen);
  }

  /** Give the window another size. The globe and the 3D pictures are left first: no processor draws them at each size. */
  async resize(size: Size): Promise<void> {
    this.size = size;
    await this.openTab(0);
    await this.devtools.send("Emulation.setTouchEmulationEnabled", { enabled: size.touch === true, maxTouchPoints: 5 });
    await this.page.setViewportSize({ width: size.width, height: size.height });
    await this.page.waitForFunction(({ width, height }) => innerWidth === width && innerHeight === height, {
      width: size.width,
      height: size.height,
    });
    await this.still();
  }

  /** Dark, light or sunlight. */
  async wear(look: string): Promise<void> {
    await this.set("theme", look);
  }

  async speak(language: "es" | "en"): Promise<void> {
    await this.set("lang", language);
  }

  /** By the menu "Ver", which every window has. */
  private async set(what: "theme" | "lang", value: string): Promise<void> {
    const choice = { dark: 0, light: 1, sunlight: 2, es: 3, en: 4 }[value] ?? 0;
    const menus = await this.openMenus();
    await menus.nth(VIEW_MENU).click();
    await this.page.getByRole("menu").getByRole("menuitemradio").nth(choice).click();
    await this.page.waitForFunction(
      ([kind, wanted]) =>
        (kind === "lang" ? document.documentElement.lang : document.documentElement.dataset.theme) === wanted,
      [what, value] as const,
    );
    await this.closeAll();
  }

  /** The titles of the menus: in the window's bar, or in the drawer. */
  private async openMenus(): Promise<Locator> {
    const bar = this.page.getByRole("menubar");
    if ((await bar.count()) === 0) await this.page.locator(".app-strip > button").click();
    return bar.getByRole("menuitem");
  }

  private async closeAll(): Promise<void> {
    for (let nth = 0; nth < 4; nth += 1) {
      if ((await this.page.locator("[role=menu], [role=dialog], [role=alertdialog]").count()) === 0) return;
      await this.page.keyboard.press("Escape");
      await this.still();
    }
  }

  /** Everything wrong with the menus, and with the dialogs that they open. */
  async overlays(): Promise<string[]> {
    const faults: string[] = [];
    await this.openTab(0);
    const hasDrawer = (await this.page.getByRole("menubar").count()) === 0;
    let menus = await this.openMenus();
    if (hasDrawer) faults.push(...(await this.look("drawer")));
    const count = await menus.count();
    for (let at = 0; at < count; at += 1) {
      await menus.nth(at).click();
      await this.page.getByRole("menu").waitFor();
      faults.push(...(await this.look(`menu ${await menus.nth(at).textContent()}`)));
      await this.page.keyboard.press("Escape");
      await this.page.getByRole("menu").waitFor({ state: "detached" });
    }
    await this.closeAll();
    for (const [menu, entry] of DIALOGS) {
      menus = await this.openMenus();
      await menus.nth(menu).click();
      const item = this.page.getByRole("menu").getByRole("menuitem", { name: entry });
      const name = await item.textContent();
      await item.click();
      await this.page.locator("[role=dialog], [role=alertdialog]").last().waitFor();
      await this.page.waitForFunction(() => document.querySelectorAll("[role=menu]").length === 0);
      faults.push(...(await this.look(`dialog ${name}`)));
      await this.closeAll();
    }
    if (hasDrawer) {
      await this.page.locator(".app-tabs > .ui-tabs-row [role=tab][aria-selected=true]").click();
      faults.push(...(await this.look("tabs of the open group")));
      await this.closeAll();
    }
    return faults;
  }

  /** Everything wrong on every main tab and every tab within it. */
  async tabs(): Promise<string[]> {
    const faults: string[] = [];
    for (const main of TABS.keys()) {
      const name = await this.openTab(main);
      faults.push(...(await this.look(name)));
      const inner = await this.page.evaluate(
        () => document.querySelectorAll("[role=tabpanel] [role=tablist] [role=tab]").length,
      );
      for (let tab = 0; tab < inner; tab += 1) {
        const within = await this.page.evaluate((at) => {
          const one = document.querySelectorAll<HTMLElement>("[role=tabpanel] [role=tablist] [role=tab]")[at];
          if (one === undefined || one.getAttribute("aria-selected") === "true") return null;
          one.click();
          return one.textContent;
        }, tab);
        if (within !== null) faults.push(...(await this.look(`${name} > ${within}`)));
      }
    }
    return faults;
  }

  /** Everything wrong with what is on top now. */
  async look(what: string): Promise<string[]> {
    await this.still();
    await this.onScreen(what);
    const isSmall = await this.page.evaluate(() => document.documentElement.dataset.layout !== "wide");
    const faults = await this.page.evaluate(layoutFaults, this.size.touch === true || isSmall ? FINGER_PX : 0);
    return faults.map((fault) => `${sizeName(this.size)} | ${what} | ${fault}`);
  }

  /** Open a main tab by its place, which sends nothing; returns its name. */
  async openTab(at: number): Promise<string> {
    const language = await this.page.evaluate(() => (document.documentElement.lang === "en" ? "en" : "es"));
    const name: string = Object.values(GROUPS[language]).flat()[at] ?? "";
    await openTab(this.page, name);
    await this.page.waitForFunction(() => document.querySelector(".app-waiting") === null);
    return name;
  }

  /** Two animation frames: what was asked for is laid out. */
  private async still(): Promise<void> {
    await this.page.evaluate(async () => {
      await document.fonts.ready;
      for (let nth = 0; nth < 3; nth += 1) await new Promise((done) => requestAnimationFrame(done));
    });
  }
}
