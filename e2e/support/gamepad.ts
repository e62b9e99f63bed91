import type { Page } from "@playwright/test";

/** A gamepad that no browser has a driver for: what `navigator.getGamepads` tells is at the journey's command. */
export class Gamepad {
  private constructor(private readonly page: Page) {}

  /** Before the page is opened. */
  static async at(page: Page): Promise<Gamepad> {
    await page.addInitScript(() => {
      const held = { axes: null as number[] | null };
      Object.assign(window, { held });
      Navigator.prototype.getGamepads = () =>
        held.axes === null
          ? []
          : [
              {
                id: "Journey Pad",
                index: 0,
                connected: true,
                mapping: "standard",
                timestamp: performance.now(),
                axes: held.axes,
                buttons: [],
                vibrationActuator: null,
              } as unknown as globalThis.Gamepad,
            ];
    });
    return new Gamepad(page);
  }

  /** Left stick across and along, right stick across and along, each -1..+1. */
  async hold(...axes: readonly [number, number, number, number]): Promise<void> {
    await this.set([...axes]);
  }

  async unplug(): Promise<void> {
    await this.set(null);
  }

  private async set(axes: number[] | null): Promise<void> {
    await this.page.evaluate((now) => {
      (window as unknown as { held: { axes: number[] | null } }).held.axes = now;
      window.dispatchEvent(new Event(now === null ? "gamepaddisconnected" : "gamepadconnected"));
    }, axes);
  }
}
