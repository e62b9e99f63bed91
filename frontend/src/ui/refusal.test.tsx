import { fireEvent, screen } from "@testing-library/react";
import userEvent, { type UserEvent } from "@testing-library/user-event";
import type { ReactElement } from "react";
import { describe, expect, test, vi } from "vitest";
import { Button } from "./Button";
import { Checkbox } from "./Checkbox";
import { FileButton } from "./FileButton";
import { Menu, MenuAction, MenuBar, MenuChoice, MenuSwitch } from "./MenuBar";
import { NumberField } from "./NumberField";
import { SegmentedSwitch } from "./SegmentedSwitch";
import { Select } from "./Select";
import { TextField } from "./TextField";
import { renderWithWords } from "./test/testWords";
import { VerticalSlider } from "./VerticalSlider";

const OPTIONS = [
  { value: "one", label: "One" },
  { value: "two", label: "Two" },
] as const;
const WHY = "no board link";

interface Case {
  /** The control with this reason, or usable without. */
  readonly draw: (run: () => void, disabledReason?: string) => ReactElement;
  readonly press: () => Promise<void>;
}

const quick = { delay: null, pointerEventsCheck: 0 } as const;

function click(role: string, name: string): () => Promise<void> {
  return async () => await userEvent.setup(quick).click(screen.getByRole(role, { name: RegExp(`^${name}`) }));
}

async function open(user: UserEvent): Promise<void> {
  screen.getByText("File").focus();
  await user.keyboard("{Enter}");
}

/** Open the one menu and press its entry. */
function choose(role: string): () => Promise<void> {
  return async () => {
    const user = userEvent.setup(quick);
    if (screen.queryByRole("menu") === null) {
      await open(user);
    }
    await user.click(screen.getByRole(role, { name: /^Two/ }));
  };
}

function inMenu(entry: ReactElement): ReactElement {
  return (
    <MenuBar label="Menus">
      <Menu label="File">{entry}</Menu>
    </MenuBar>
  );
}

const CASES: Readonly<Record<string, Case>> = {
  button: {
    draw: (run, why) => (
      <Button onPress={run} disabledReason={why}>
        Two
      </Button>
    ),
    press: click("button", "Two"),
  },
  "file button": {
    draw: (run, why) => (
      <FileButton onFile={run} accept=".json" disabledReason={why}>
        Two
      </FileButton>
    ),
    press: click("button", "Two"),
  },
  checkbox: {
    draw: (run, why) => <Checkbox label="Two" checked={false} onChange={run} disabledReason={why} />,
    press: click("checkbox", "Two"),
  },
  switch: {
    draw: (run, why) => (
      <SegmentedSwitch label="S" options={OPTIONS} value="one" onChange={run} disabledReason={why} />
    ),
    press: click("radio", "Two"),
  },
  "menu entry": {
    draw: (run, why) => inMenu(<MenuAction label="Two" onChoose={run} disabledReason={why} />),
    press: choose("menuitem"),
  },
  "menu switch": {
    draw: (run, why) =>
      inMenu(<MenuSwitch label="Two" checked={false} onChange={run} disabledReason={why} />),
    press: choose("menuitemcheckbox"),
  },
  "menu choice": {
    draw: (run, why) =>
      inMenu(<MenuChoice label="C" options={OPTIONS} value="one" onChange={run} disabledReason={why} />),
    press: choose("menuitemradio"),
  },
  select: {
    draw: (run, why) => (
      <Select label="S" options={OPTIONS} value="one" placeholder="" onChange={run} disabledReason={why} />
    ),
    press: async () => {
      const user = userEvent.setup(quick);
      screen.getByRole("combobox").focus();
      await user.keyboard("{ArrowDown}");
    },
  },
  "text field": {
    draw: (run, why) => <TextField label="T" value="x" onCommit={run} onEnter={run} disabledReason={why} />,
    press: async () => {
      screen.getByRole("textbox").focus();
      await userEvent.setup(quick).keyboard("{Enter}");
    },
  },
  slider: {
    draw: (run, why) => (
      <VerticalSlider
        label="1"
        name="S"
        value={0}
        minimum={-1}
        maximum={1}
        step={0.1}
        rest={0}
        format={String}
        noValueText=""
        onMove={run}
        state="idle"
        disabledReason={why}
      />
    ),
    press: async () => void fireEvent.change(screen.getByRole("slider"), { target: { value: "0.5" } }),
  },
  "step of a number": {
    draw: (run, why) => (
      <NumberField label="N" value={1} minimum={0} maximum={2} step={1} onCommit={run} disabledReason={why} />
    ),
    press: click("button", "w-increase N"),
  },
};

describe.each(Object.entries(CASES))("a greyed %s", (_name, { draw, press }) => {
  test("answers a press with its reason, once, and does nothing else", async () => {
    const run = vi.fn();
    const { refused } = renderWithWords(draw(run, WHY));
    await press();
    expect(refused).toEqual([WHY]);
    expect(run).not.toHaveBeenCalled();
  });
});

// A file's choice and a list that opens belong to the browser.
const RUN = Object.entries(CASES).filter(([name]) => name !== "file button" && name !== "select");

test.each(RUN)(
  "a %s whose reason is gone by the time of the press is carried out once",
  async (_name, { draw, press }) => {
    const run = vi.fn();
    const { rerender, refused } = renderWithWords(draw(run, WHY));
    await press();
    rerender(draw(run));
    await press();
    expect(run).toHaveBeenCalledTimes(1);
    expect(refused).toEqual([WHY]);
  },
);

test("a greyed menu entry is still reached, told apart and named with its reason", async () => {
  renderWithWords(inMenu(<MenuAction label="Two" onChoose={vi.fn()} disabledReason={WHY} />));
  await open(userEvent.setup(quick));
  const entry = screen.getByRole("menuitem", { name: `Two ${WHY}` });
  expect(entry.getAttribute("aria-disabled")).toBe("true");
  expect(entry.hasAttribute("data-disabled")).toBe(true);
});

test("a position that can always be asked for is, once a press, where the switch is greyed and where it stands", async () => {
  const run = vi.fn();
  const options = [OPTIONS[0], { ...OPTIONS[1], always: true }];
  const { rerender, refused } = renderWithWords(
    <SegmentedSwitch label="S" options={options} value="one" onChange={run} disabledReason={WHY} />,
  );
  const two = screen.getByRole("radio", { name: "Two" });
  expect(two.closest('[aria-disabled="true"]')).toBeNull();
  await userEvent.click(two);
  rerender(<SegmentedSwitch label="S" options={options} value="two" onChange={run} />);
  await userEvent.click(two);
  expect(run.mock.calls).toEqual([["two"], ["two"]]);
  expect(refused).toEqual([]);
});
