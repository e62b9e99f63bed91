import { act, fireEvent, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";
import { TAB_GROUPS } from "../views/views";

/** The window's size, which media queries see. */
let size = { width: 1366, height: 768, isCoarse: false };
const listeners = new Set<() => void>();

/** The few media queries that the layout asks, answered for `size`. */
function matches(query: string): boolean {
  return query.split(", ").some((one) =>
    [...one.matchAll(/\((?<what>[a-z]+)(?::| [<>]=?) (?<value>[\w.]+)\)/g)].every(
      ({ 0: text, groups = {} }) => {
        const rem = 16 * Number.parseFloat(groups["value"] ?? "");
        switch (groups["what"]) {
          case "pointer":
            return size.isCoarse;
          case "orientation":
            return size.width > size.height;
          default: {
            const length = groups["what"] === "width" ? size.width : size.height;
            return text.includes(">=") ? length >= rem : length < rem;
          }
        }
      },
    ),
  );
}

function resize(width: number, height: number, isCoarse = true): void {
  size = { width, height, isCoarse };
  act(() => {
    for (const run of listeners) run();
  });
}

function layout(): string | undefined {
  return document.documentElement.dataset["layout"];
}

beforeEach(() => {
  size = { width: 1366, height: 768, isCoarse: false };
  vi.stubGlobal("matchMedia", (query: string) => ({
    get matches() {
      return matches(query);
    },
    addEventListener: (_: string, run: () => void) => listeners.add(run),
    removeEventListener: (_: string, run: () => void) => listeners.delete(run),
  }));
});

afterEach(() => {
  vi.unstubAllGlobals();
  listeners.clear();
});

function onPhone(): Station {
  const station = new Station();
  station.greet(aStatus());
  resize(360, 640);
  return station;
}

test.each([
  [360, 640, true, "column"],
  [412, 915, true, "column"],
  [915, 412, true, "beside"],
  [768, 1024, true, "column"],
  [1024, 768, true, "beside"],
  [1024, 768, false, "wide"],
  [1366, 768, true, "wide"],
  [1366, 768, false, "wide"],
  [3840, 2160, false, "wide"],
  [683, 384, false, "beside"],
  [320, 256, false, "column"],
])("a window of %i × %i, touched %s, is laid out %s", (width, height, isCoarse, wanted) => {
  new Station().greet();
  resize(width, height, isCoarse);
  expect(layout()).toBe(wanted);
});

test("a wide window has no drawer, and its groups of tabs no menus", () => {
  new Station().greet();
  expect(screen.queryByRole("button", { name: "Menú" })).toBeNull();
  fireEvent.click(group("Vuelo"));
  expect(screen.queryByRole("menu")).toBeNull();
  expect(screen.getByRole("tab", { name: "Datos de vuelo" })).toBeTruthy();
});

function group(name: string): HTMLElement {
  const bar = screen.getByRole("tablist", { name: "Pestañas principales" });
  return within(bar).getByRole("tab", { name });
}

describe("on a phone", () => {
  test("the bar has the groups of a wide window in the same order", () => {
    onPhone();
    const bar = screen.getByRole("tablist", { name: "Pestañas principales" });
    const names = within(bar)
      .getAllByRole("tab")
      .map(({ textContent }) => textContent);
    expect(names[0]).toBe("Vuelo");
    expect(names).toHaveLength(TAB_GROUPS.length);
    expect(screen.getAllByRole("tablist")[0]).toBe(bar);
  });

  test("a press on a group opens it, a further one the menu of its tabs", async () => {
    const user = userEvent.setup();
    const station = onPhone();
    await user.click(group("HIL"));
    expect(screen.queryByRole("menu"), "the press that opened the group").toBeNull();
    await user.click(group("HIL"));
    station.show();
    await user.click(screen.getByRole("menuitemradio", { name: "AHRS 3D" }));
    station.show();
    expect(screen.getByRole("tabpanel", { name: "AHRS 3D" })).toBeTruthy();
    expect(screen.queryByRole("menu")).toBeNull();
  });

  test("a group of one tab has no menu", async () => {
    const user = userEvent.setup();
    onPhone();
    await user.click(group("Setup"));
    await user.click(group("Setup"));
    expect(screen.queryByRole("menu")).toBeNull();
    expect(group("Setup").hasAttribute("aria-haspopup")).toBe(false);
  });

  test("what is flown by stands over every tab: attitude, heading, speeds, altitude", () => {
    onPhone();
    const flying = screen.getByRole("complementary");
    expect(within(flying).getAllByRole("img")).toHaveLength(2);
    for (const name of ["Aire", "Suelo", "Altura", "Heading", "Autopilot"]) {
      expect(within(flying).getByText(name)).toBeTruthy();
    }
  });

  test("the drawer has both toolbars, all menus, the pilot's controls and the links", () => {
    onPhone();
    fireEvent.click(screen.getByRole("button", { name: "Menú" }));
    const drawer = screen.getByRole("dialog", { name: "Menú" });
    for (const name of ["Autopilot", "Autotrim", "X-Plane", "Fuente"]) {
      expect(within(drawer).getByRole("group", { name })).toBeTruthy();
    }
    expect(within(within(drawer).getByRole("menubar")).getAllByRole("menuitem")).toHaveLength(7);
    expect(within(drawer).getByRole("region", { name: "Controles" })).toBeTruthy();
    expect(within(drawer).getByText("Dañadas")).toBeTruthy();
  });

  test("a switch in the drawer commands as the toolbar does", () => {
    const station = onPhone();
    station.send({ heartbeat: { source_joystick: true, autopilot_hil: false } });
    fireEvent.click(screen.getByRole("button", { name: "Menú" }));
    const autopilot = within(screen.getByRole("dialog")).getByRole("group", { name: "Autopilot" });
    fireEvent.click(within(autopilot).getByRole("radio", { name: "On" }));
    expect(station.asked.at(-1)).toMatchObject({ method: "POST", path: "/api/v1/commands/autopilot_on" });
  });

  test("the time bar is folded away until it is wanted", () => {
    onPhone();
    const app = document.querySelector<HTMLElement>(".app");
    expect(app?.dataset["time"]).toBe("folded");
    fireEvent.click(screen.getByRole("button", { name: "Menú" }));
    fireEvent.click(screen.getByRole("radio", { name: "A la vista" }));
    expect(app?.dataset["time"]).toBe("shown");
  });

  test("turned or made wide, the open tab is the same as before", () => {
    onPhone();
    const panel = screen.getAllByRole("tabpanel")[0]?.firstElementChild;
    expect(panel).toBeTruthy();
    resize(915, 412);
    expect(screen.getAllByRole("tabpanel")[0]?.firstElementChild).toBe(panel);
    resize(1366, 768, false);
    expect(screen.getAllByRole("tabpanel")[0]?.firstElementChild).toBe(panel);
  });
});
