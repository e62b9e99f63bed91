import { screen, within } from "@testing-library/react";
import { expect, test } from "vitest";
import { AlarmStrip } from "./AlarmStrip";
import { renderWithWords } from "./test/words";

const LOST = { id: "heartbeat_lost", level: "critical", text: "Heartbeat lost", detail: "4 s" } as const;
const HIL = { id: "hil_lost", level: "warning", text: "Simulator silent" } as const;

test("critical alarms interrupt, warnings wait their turn, and both have their level in words", () => {
  renderWithWords(<AlarmStrip label="Alarms" alarms={[HIL, LOST]} />);
  const strip = screen.getByRole("region", { name: "Alarms" });
  expect(within(strip).getByRole("alert").textContent).toBe("w-criticalHeartbeat lost4 s");
  expect(within(strip).getByRole("status").textContent).toBe("w-warningSimulator silent");
});

test("the live regions are there before the first alarm and after the last", () => {
  const { rerender } = renderWithWords(<AlarmStrip label="Alarms" alarms={[]} />);
  const region = screen.getByRole("alert");
  rerender(<AlarmStrip label="Alarms" alarms={[LOST]} />);
  expect(screen.getByRole("alert")).toBe(region);
  rerender(<AlarmStrip label="Alarms" alarms={[]} />);
  expect(region.textContent).toBe("");
});

test("an alarm that goes on keeps its line while its age changes, so that it is not read out again", () => {
  const { rerender } = renderWithWords(<AlarmStrip label="Alarms" alarms={[LOST]} />);
  const line = screen.getByText("Heartbeat lost");
  rerender(<AlarmStrip label="Alarms" alarms={[{ ...LOST, detail: "5 s" }]} />);
  expect(screen.getByText("Heartbeat lost")).toBe(line);
  expect(screen.getByText("5 s")).toBeDefined();
  expect(screen.getByRole("alert").getAttribute("aria-relevant")).toBe("additions");
});
