import { render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { TabRow, Tabs } from "./Tabs";

const TABS = [
  { value: "flight", label: "Flight", content: "flight panel" },
  { value: "hil", label: "HIL", content: "hil panel" },
  { value: "setup", label: "Setup", content: "setup panel" },
] as const;

test("the first tab is open, and the arrow keys open the next", async () => {
  render(<Tabs label="Main" tabs={TABS} />);
  expect(screen.getByRole("tablist", { name: "Main" })).toBeDefined();
  expect(screen.getByRole("tabpanel", { name: "Flight" }).textContent).toBe("flight panel");
  await userEvent.tab();
  await userEvent.keyboard("{ArrowRight}");
  expect((await screen.findByRole("tabpanel", { name: "HIL" })).textContent).toBe("hil panel");
  expect(screen.queryByText("flight panel")).toBeNull();
});

test("a closed tab that is kept stays in the document", () => {
  render(<Tabs label="Main" tabs={TABS} defaultValue="setup" keepMounted />);
  expect(screen.getByText("flight panel").hidden).toBe(true);
  expect(screen.getByRole("tab", { name: "Setup" }).getAttribute("aria-selected")).toBe("true");
});

test("a page that owns the open tab is asked and decides", async () => {
  const onValueChange = vi.fn();
  render(<Tabs label="Main" tabs={TABS} value="flight" onValueChange={onValueChange} />);
  await userEvent.click(screen.getByRole("tab", { name: "Setup" }));
  expect(onValueChange).toHaveBeenCalledWith("setup");
  expect(screen.getByText("flight panel")).toBeDefined();
});

test("a press on the open tab is told, the press that opened it is not", async () => {
  const onPressAgain = vi.fn();
  const { rerender } = render(<Tabs label="Main" tabs={TABS} value="flight" onPressAgain={onPressAgain} />);
  const setup = screen.getByRole("tab", { name: "Setup" });
  await userEvent.click(setup);
  expect(onPressAgain).not.toHaveBeenCalled();
  rerender(<Tabs label="Main" tabs={TABS} value="setup" onPressAgain={onPressAgain} />);
  await userEvent.click(setup);
  expect(onPressAgain).toHaveBeenCalledExactlyOnceWith("setup", setup);
});

test("a row of tabs without panels opens by press and by arrow key", async () => {
  const onValueChange = vi.fn();
  render(<TabRow label="Group" tabs={TABS} value="flight" onValueChange={onValueChange} />);
  await userEvent.click(screen.getByRole("tab", { name: "Setup" }));
  expect(onValueChange).toHaveBeenLastCalledWith("setup");
});
