import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, expect, test, vi } from "vitest";
import { type AlarmItem, AlarmStrip } from "./AlarmStrip";
import { renderWithWords } from "./test/testWords";

const LOST: AlarmItem = {
  id: "heartbeat_lost",
  level: "critical",
  text: "Heartbeat lost",
  acknowledged: false,
  detail: "4 s",
};
const HIL: AlarmItem = { id: "hil_lost", level: "warning", text: "Simulator silent", acknowledged: false };
const GPS: AlarmItem = { id: "gps_lost", level: "critical", text: "GPS lost", acknowledged: false };

const onPress = vi.fn();
afterEach(() => onPress.mockClear());

const acknowledge = { label: (text: string) => `know ${text}`, text: "know", onPress };

function strip(alarms: readonly AlarmItem[]) {
  return (
    <AlarmStrip label="Alarms" alarms={alarms} acknowledge={acknowledge}>
      <button type="button">all</button>
    </AlarmStrip>
  );
}

test("critical alarms interrupt, warnings wait their turn, and both have their level in words", () => {
  renderWithWords(strip([LOST, HIL]));
  const region = screen.getByRole("region", { name: "Alarms" });
  expect(within(region).getByRole("alert").textContent).toBe("w-criticalHeartbeat lost4 sknow");
  expect(within(region).getByRole("status").textContent).toBe("w-warningSimulator silentknow");
});

test("the live regions are there before the first alarm and after the last", () => {
  const { rerender } = renderWithWords(strip([]));
  const region = screen.getByRole("alert");
  rerender(strip([LOST]));
  expect(screen.getByRole("alert")).toBe(region);
  rerender(strip([]));
  expect(region.textContent).toBe("");
});

test("an alarm that goes on keeps its line while its detail changes, so that it is not read out again", () => {
  const { rerender } = renderWithWords(strip([LOST]));
  const line = screen.getByText("Heartbeat lost");
  rerender(strip([{ ...LOST, detail: "5 s" }]));
  expect(screen.getByText("Heartbeat lost")).toBe(line);
  expect(screen.getByText("5 s")).toBeDefined();
  expect(screen.getByRole("alert").getAttribute("aria-relevant")).toBe("additions");
});

test("two alarms have a line each; a third is heard, has no line and no button", () => {
  renderWithWords(strip([LOST, GPS, HIL]));
  expect(screen.getByRole("status").textContent).toContain("Simulator silent");
  expect(screen.getByText("Simulator silent").closest(".visually-hidden")).not.toBeNull();
  expect(screen.getAllByRole("button", { name: /^know/ })).toHaveLength(2);
});

test("each line acknowledges its own alarm; one that is known has nothing left to press", async () => {
  renderWithWords(strip([LOST, { ...HIL, acknowledged: true }]));
  await userEvent.setup().click(screen.getByRole("button", { name: "know Heartbeat lost" }));
  expect(onPress.mock.calls).toEqual([["heartbeat_lost"]]);
  expect(screen.queryByRole("button", { name: "know Simulator silent" })).toBeNull();
});

test("an alarm that may not be acknowledged here says why, and does nothing", async () => {
  renderWithWords(strip([{ ...LOST, blocked: "viewer" }]));
  const button = screen.getByRole("button", { name: "know Heartbeat lost" });
  await userEvent.setup().click(button);
  expect(onPress).not.toHaveBeenCalled();
  expect(document.getElementById(button.getAttribute("aria-describedby") ?? "")?.textContent).toBe("viewer");
});

test("what can be done about all of them is there while there is any", () => {
  const { rerender } = renderWithWords(strip([LOST]));
  expect(screen.getByRole("button", { name: "all" })).toBeDefined();
  rerender(strip([]));
  expect(screen.queryByRole("button", { name: "all" })).toBeNull();
});
