import { act, fireEvent, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import { TIME_KEYS } from "../../features/playback/timeKeys";
import { Station } from "../../test/station";
import { chooseKeys } from "../settings/choices";
import { TAB_GROUPS, TABS } from "../views/views";
import { SHORTCUTS } from "./table";

const QUICK = { pointerEventsCheck: 0, delay: null } as const;

function flying(): Station {
  const station = new Station();
  station.greet();
  station.send({ heartbeat: { autopilot_hil: false, source_joystick: true } });
  return station;
}

function press(key: string, target: Element = document.body): void {
  fireEvent.keyDown(target, { key });
}

function asked(station: Station): string[] {
  return station.asked.filter(({ method }) => method !== "GET").map(({ path }) => path);
}

describe("a key that commands the aircraft", () => {
  test("does nothing before Enter confirms it, and says what it waits for", () => {
    const station = flying();
    press("a");
    expect(asked(station)).toEqual([]);
    expect(screen.getByText("Autopilot On").parentElement?.textContent).toContain("Intro: confirmar");
    press("Enter");
    expect(asked(station)).toEqual(["/api/v1/commands/autopilot_on"]);
    press("Enter");
    expect(asked(station)).toHaveLength(1);
  });

  test("is taken back by Escape and by any other of the page's keys", () => {
    const station = flying();
    press("A");
    press("Escape");
    press("Enter");
    press("m");
    press("o");
    press("Enter");
    expect(station.asked.filter(({ method }) => method !== "GET").map(({ body }) => body)).toEqual([
      { path: "assisted" },
    ]);
  });

  test("does not press the focused button with its Enter", () => {
    const station = flying();
    const button = screen.getByText("Soltar").closest("button");
    button?.focus();
    press("t");
    expect(fireEvent.keyDown(button ?? document.body, { key: "Enter" })).toBe(false);
    expect(asked(station)).toEqual(["/api/v1/commands/autotrim_on"]);
  });
});

describe("no key does anything", () => {
  test("while somebody types, or with Ctrl, Alt or the system's key, or when it is held", () => {
    const station = flying();
    const field = document.createElement("input");
    document.body.append(field);
    press("l", field);
    field.remove();
    for (const held of [{ ctrlKey: true }, { altKey: true }, { metaKey: true }, { repeat: true }]) {
      fireEvent.keyDown(document.body, { key: "l", ...held });
    }
    expect(asked(station)).toEqual([]);
    press("l");
    expect(asked(station)).toEqual(["/api/v1/commands/read_all"]);
  });

  test("when the keys are switched off", () => {
    const station = flying();
    act(() => chooseKeys(station.page.settings, false));
    press("l");
    expect(asked(station)).toEqual([]);
  });
});

test("the keys work again when a menu, or a dialog that came from one, was closed", async () => {
  const user = userEvent.setup(QUICK);
  const station = flying();
  const tab = (): string | undefined => station.page.settings.getState().choices["tab"];
  const title = screen.getByRole("menuitem", { name: "Ayuda" });
  title.focus();
  await user.keyboard("{Enter}");
  station.show();
  await user.keyboard("4");
  expect(tab(), "an open menu keeps its keys").toBe("flight");
  await user.keyboard("{Escape}");
  expect(document.activeElement).toBe(title);
  await user.keyboard("2");
  expect(tab()).toBe("plans");
  await user.keyboard("a{Enter}");
  expect(asked(station), "Enter confirms, and opens no menu").toEqual(["/api/v1/commands/autopilot_on"]);

  await user.keyboard("{Enter}");
  station.show();
  await user.click(screen.getByText("Atajos de teclado"));
  screen.getByRole("dialog", { name: "Atajos de teclado" });
  await user.keyboard("4{Escape}");
  expect(tab()).toBe("plans");
  await user.keyboard("4");
  expect(tab()).toBe("hil");
});

test("the digits open the groups of tabs in their order on the screen, and again each tab of a group in turn", () => {
  const station = flying();
  const opened: Array<string | undefined> = [];
  for (const [place, { tabs }] of TAB_GROUPS.entries()) {
    for (const _ of tabs) {
      press(`${place + 1}`);
      opened.push(station.page.settings.getState().choices["tab"]);
    }
  }
  // The page began on the second tab of the first group.
  expect(opened).toEqual(["six", "fly", "flight", ...TABS.slice(3)]);
  press("1");
  expect(station.page.settings.getState().choices["tab"], "where the group was left").toBe("flight");
});

test("each shortcut has a key, and no two have the same", () => {
  const keys = SHORTCUTS.map(({ key }) => key);
  expect(keys).not.toContain("");
  expect(new Set(keys).size).toBe(keys.length);
});

test("the help sheet, opened by a question mark, names every key", () => {
  flying();
  press("?");
  const sheet = screen.getByRole("dialog", { name: "Atajos de teclado" });
  const shown = [...sheet.querySelectorAll("dt")].map((term) =>
    [...term.querySelectorAll("kbd")].map(({ textContent }) => textContent).join(" "),
  );
  expect(shown).toHaveLength(SHORTCUTS.length + TIME_KEYS.length);
  expect(shown).toContain("Mayús A Intro");
  expect(shown).toContain("?");
  expect(shown).toContain("Mayús ← →");
  expect(shown).toContain("Re Pág Av Pág");
  expect(shown).toContain("Inicio Fin");
  // The sheet keeps the keys from the page.
  press("1", sheet);
  expect(sheet.isConnected).toBe(true);
});
