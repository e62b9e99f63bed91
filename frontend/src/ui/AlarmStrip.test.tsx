import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, expect, test, vi } from "vitest";
import { type AlarmItem, AlarmStrip, type EndedItem, endedWithoutPlace } from "./AlarmStrip";
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

const ENDED: EndedItem = { id: "gps_lost", level: "warning", text: "GPS lost", detail: "12:03" };
const onSeen = vi.fn();

function strip(alarms: readonly AlarmItem[], items: readonly EndedItem[] = []) {
  const ended = {
    label: "ended",
    items,
    acknowledge: { label: (text: string) => `seen ${text}`, onPress: onSeen },
  };
  return (
    <AlarmStrip label="Alarms" quiet="nothing" alarms={alarms} ended={ended} acknowledge={acknowledge}>
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

test("without alarms its place says so", () => {
  const { rerender } = renderWithWords(strip([]));
  expect(screen.getByRole("region").textContent).toBe("nothing");
  rerender(strip([], [ENDED]));
  expect(screen.queryByText("nothing")).toBeNull();
});

test("what can be done about all of them is there while there is any", () => {
  const { rerender } = renderWithWords(strip([LOST]));
  expect(screen.getByRole("button", { name: "all" })).toBeDefined();
  rerender(strip([]));
  expect(screen.queryByRole("button", { name: "all" })).toBeNull();
});

test("what ended stands in the line that the alarms leave, outside of what interrupts, and each can be acknowledged", async () => {
  renderWithWords(strip([LOST], [ENDED]));
  expect(screen.getByRole("listitem").textContent).toBe("GPS lost12:03");
  expect(screen.getByRole("alert").textContent).not.toContain("GPS");
  await userEvent.setup().click(screen.getByRole("button", { name: "seen GPS lost" }));
  expect(onSeen.mock.calls).toEqual([["gps_lost"]]);
});

test("what ended and may not be acknowledged here says why, and does nothing", async () => {
  onSeen.mockClear();
  renderWithWords(strip([], [{ ...ENDED, blocked: "viewer" }]));
  const button = screen.getByRole("button", { name: "seen GPS lost" });
  await userEvent.setup().click(button);
  expect(onSeen).not.toHaveBeenCalled();
  expect(document.getElementById(button.getAttribute("aria-describedby") ?? "")?.textContent).toBe("viewer");
});

test("what ended gives way to two alarms, and more than three are left to the list", () => {
  renderWithWords(strip([LOST, HIL], [ENDED]));
  expect(screen.queryByRole("listitem")).toBeNull();
  expect([endedWithoutPlace(2, 1), endedWithoutPlace(1, 1), endedWithoutPlace(0, 5)]).toEqual([1, 0, 2]);
});
