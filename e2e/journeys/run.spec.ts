import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { expect, test } from "@playwright/test";
import { freeTcpPort, Program, ROOT, until } from "../support/processes.js";

test("one command flies: it prints the page's address, the loop is closed, and Ctrl-C leaves nothing behind", async ({
  page,
}) => {
  const data = await mkdtemp(path.join(tmpdir(), "epf-run-"));
  const port = await freeTcpPort();
  const launcher = new Program("epf-run", `${ROOT}/.venv/bin/epf-run`, ["--port", `${port}`, "--data-dir", data]);
  const url = `http://127.0.0.1:${port}`;
  try {
    await until(`the address\n${launcher.output}`, () => (launcher.output.includes(url) ? true : undefined));
    await page.goto(url, { waitUntil: "domcontentloaded" });
    await expect(page.getByRole("img", { name: "Indicador de actitud" })).toHaveAttribute("data-state", "live");
    // The first waypoint is 2.4 km away; its distance shrinks until it is reached, while the board's own code flies there.
    const plan = async () => {
      const telemetry = await (await fetch(`${url}/api/v1/telemetry`)).json();
      return telemetry.fms_hil_plan.values as { waypoint: number; distance_m: number };
    };
    const first = await plan();
    await expect
      .poll(async () => {
        const { waypoint, distance_m } = await plan();
        return waypoint !== first.waypoint || distance_m < first.distance_m - 200;
      })
      .toBe(true);
  } finally {
    expect(await launcher.stop("SIGINT")).toBe(0);
    await rm(data, { recursive: true, force: true });
  }
  await expect(fetch(`${url}/api/v1/status`)).rejects.toThrow();
});
