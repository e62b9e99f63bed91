import { expect, test } from "vitest";
import { refusedInPast } from "./pastGuard";

test.each([
  ["POST", "/api/v1/commands/autopilot_off"],
  ["PUT", "/api/v1/hil"],
  ["PATCH", "/api/v1/parameters"],
  ["POST", "/api/v1/parameters/load"],
  ["PUT", "/api/v1/missions/flight"],
  ["GET", "/api/v1/missions/flight"],
  ["DELETE", "/api/v1/links/board"],
  ["POST", "/api/v1/control"],
  ["POST", "/api/v1/console"],
  ["POST", "/api/v1/track/reset"],
  ["POST", "/api/v1/alarms/x/../../commands/reset"],
  ["POST", "/api/v1/flightsX"],
])("%s %s does not leave the page while it shows the past", (method, path) => {
  expect(refusedInPast(method, path)?.code).toBe("in_the_past");
});

test.each([
  ["GET", "/api/v1/flights/20260131T120000Z/known?at_s=3"],
  ["GET", "/api/v1/alarms"],
  ["POST", "/api/v1/alarms/battery_low/acknowledge"],
  ["POST", "/api/v1/flights/20260131T120000Z/marks"],
  ["DELETE", "/api/v1/jobs/7"],
  ["POST", "/api/v1/missions/export?format=kml"],
])("%s %s does", (method, path) => {
  expect(refusedInPast(method, path)).toBeNull();
});
