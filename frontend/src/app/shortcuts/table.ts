import { ALARM_LOG } from "../../features/alarms/alarmLog";
import { CAMERA_CHOICE, cameraOf, nextCamera } from "../../lib/mapCamera";
import type { CommandName } from "../../protocol/messages.gen";
import { ACTIONS } from "../../requests/actions";
import { otherHolder } from "../../requests/useControl";
import type { Page } from "../../store/hooks";
import type { MessageParams } from "../../store/messages";
import { choose } from "../../store/settings";
import type { DialogName } from "../views/useDialogs";
import { openGroup, TAB_GROUPS } from "../views/views";

/** What a shortcut can use. */
export interface Reach {
  readonly page: Page;
  readonly open: (dialog: DialogName) => void;
}

export const GROUPS = ["tabs", "flight", "window"] as const;

/** One key. What it does is named by a key of the catalogue. */
export interface Shortcut {
  /** The browser's name of the key; a capital letter needs Shift. */
  readonly key: string;
  readonly group: (typeof GROUPS)[number];
  readonly words: string;
  readonly params?: MessageParams;
  /** Needs Enter as a second key, so that a slip switches nothing in flight. */
  readonly isArmed: boolean;
  readonly run: (reach: Reach) => void;
}

function command(key: string, name: CommandName, control: string, asked?: string): Shortcut {
  return {
    key,
    group: "flight",
    words: `command.${name}`,
    isArmed: true,
    run: ({ page }) =>
      void page.parts.get(ACTIONS).command(name, asked === undefined ? { control } : { control, asked }),
  };
}

/** The one list of shortcuts: the keys are bound and the help sheet is written from it. */
export const SHORTCUTS: readonly Shortcut[] = [
  // The digits in the order in which the groups stand.
  ...TAB_GROUPS.map(
    (group, place): Shortcut => ({
      key: `${place + 1}`,
      group: "tabs",
      words: group.tabs.length > 1 ? "shortcut.group" : "shortcut.tab",
      params: { tab: `@tabGroup.${group.name}` },
      isArmed: false,
      run: ({ page }) => openGroup(page.settings, group),
    }),
  ),
  command("a", "autopilot_on", "autopilot", "on"),
  command("A", "autopilot_off", "autopilot", "off"),
  command("t", "autotrim_on", "autotrim", "on"),
  command("T", "autotrim_off", "autotrim", "off"),
  ...(["joystick", "rc"] as const).map(
    (source): Shortcut => ({
      key: { joystick: "j", rc: "r" }[source],
      group: "flight",
      words: `command.hil_source_${source}`,
      isArmed: true,
      run: ({ page }) =>
        void page.parts.get(ACTIONS).setHil({ source }, { control: "source", asked: source }),
    }),
  ),
  ...(["manual", "assisted"] as const).map(
    (path): Shortcut => ({
      key: { manual: "m", assisted: "o" }[path],
      group: "flight",
      words: `command.hil_path_${path}`,
      isArmed: true,
      run: ({ page }) => void page.parts.get(ACTIONS).setHil({ path }, { control: "path", asked: path }),
    }),
  ),
  {
    key: "l",
    group: "flight",
    words: "command.read_all",
    isArmed: false,
    run: ({ page }) => void page.parts.get(ACTIONS).command("read_all", { control: "read_all" }),
  },
  {
    key: "c",
    group: "flight",
    words: "control.take",
    isArmed: false,
    run: ({ page }) => {
      const action = otherHolder(page.connection.getState()) === null ? "take" : "ask";
      void page.parts.get(ACTIONS).changeControl({ action }, { control: "control" });
    },
  },
  {
    key: "v",
    group: "window",
    words: "map.view.nextCamera",
    isArmed: false,
    run: ({ page }) => {
      const mode = cameraOf(page.settings.getState().choices[CAMERA_CHOICE]);
      choose(page.settings, CAMERA_CHOICE, nextCamera(mode));
    },
  },
  {
    key: "s",
    group: "window",
    words: "alarmLog.mute",
    isArmed: false,
    run: ({ page }) => page.parts.get(ALARM_LOG).mute(),
  },
  {
    key: "L",
    group: "window",
    words: "menu.log",
    isArmed: false,
    run: ({ open }) => open("log"),
  },
  {
    key: ",",
    group: "window",
    words: "menu.settings",
    isArmed: false,
    run: ({ open }) => open("settings"),
  },
  {
    key: "?",
    group: "window",
    words: "menu.shortcuts",
    isArmed: false,
    run: ({ open }) => open("shortcuts"),
  },
];
