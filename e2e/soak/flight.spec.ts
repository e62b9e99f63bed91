import { readdirSync, readFileSync } from "node:fs";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { expect, test } from "@playwright/test";
import { freeTcpPort, Program, ROOT, until } from "../support/processes.js";

/** Real time under one launcher, page open: memory flat, no frame lost, no error in any log. `make soak MINUTES=30`. */
const MINUTES = Number(process.env.SOAK_MINUTES ?? "30");
const SAMPLE_MS = 15_000;
/** The map keeps the flight's own track and grows with it, up to a bound: its memory is measured in the bench. */
const LEFT_OUT = "Mapa 3D";
/** The first minutes fill caches and pools; growth is judged after them. */
const WARM_UP_SHARE = 0.2;

type Sample = { minute: number; gateway_mb: number; heap_mb: number; waypoint: number };

function residentMb(pid: number): number {
  const line = readFileSync(`/proc/${pid}/status`, "utf8").match(/VmRSS:\s+(\d+) kB/);
  return Number(line?.[1]) / 1024;
}

/** The gateway is a child of the launcher; its command line tells it from the board and the simulator. */
function gatewayPid(launcher: number): number {
  for (const name of readdirSync("/proc")) {
    if (!/^\d+$/.test(name)) continue;
    try {
      const parent = readFileSync(`/proc/${name}/stat`, "utf8").split(") ")[1]?.split(" ")[1];
      const command = readFileSync(`/proc/${name}/cmdline`, "utf8");
      if (Number(parent) === launcher && command.includes("\0gateway\0")) return Number(name);
    } catch {
      // a process that has just ended
    }
  }
  throw new Error("no gateway process");
}

const middle = (values: number[]): number =>
  values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)] ?? Number.NaN;

test(`${MINUTES} minutes of flight leave memory flat, lose no frame and log no error`, async ({ page }) => {
  test.setTimeout((MINUTES + 5) * 60_000);
  const data = await mkdtemp(path.join(tmpdir(), "epf-soak-"));
  const port = await freeTcpPort();
  const launcher = new Program("epf-run", `${ROOT}/.venv/bin/epf-run`, ["--port", `${port}`, "--data", data]);
  const said: string[] = [];
  page.on("console", (message) => {
    // The browser's own remark on software graphics: a frame is waited for.
    if (!message.text().includes("GPU stall due to ReadPixels")) said.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => said.push(`${error}`));
  try {
    const url = `http://127.0.0.1:${port}`;
    await until("the page's address", () => (launcher.output.includes(url) ? true : undefined));
    await page.goto(url, { waitUntil: "domcontentloaded" });
    const pid = gatewayPid(launcher.pid);
    const devtools = await page.context().newCDPSession(page);
    await devtools.send("HeapProfiler.enable");

    const samples: Sample[] = [];
    const started = Date.now();
    const status = async () => await (await fetch(`${url}/api/v1/status`)).json();
    const before = await status();
    const tabs = page
      .getByRole("tablist", { name: "Pestañas principales" })
      .getByRole("tab")
      .filter({ hasNotText: LEFT_OUT });
    for (let turn = 0; Date.now() - started < MINUTES * 60_000; turn += 1) {
      // Each tab in turn: what one of them keeps when it is left is found as well as what it gathers.
      await tabs.nth(turn % (await tabs.count())).click();
      await new Promise((resolve) => setTimeout(resolve, SAMPLE_MS));
      await devtools.send("HeapProfiler.collectGarbage");
      const { usedSize } = await devtools.send("Runtime.getHeapUsage");
      const telemetry = await (await fetch(`${url}/api/v1/telemetry`)).json();
      const sample = {
        minute: (Date.now() - started) / 60_000,
        gateway_mb: residentMb(pid),
        heap_mb: usedSize / 1e6,
        waypoint: telemetry.fms_hil_plan.values.waypoint,
      };
      samples.push(sample);
      console.log(
        `${sample.minute.toFixed(1)} min  gateway ${sample.gateway_mb.toFixed(1)} MB  page ${sample.heap_mb.toFixed(1)} MB  waypoint ${sample.waypoint}`,
      );
    }
    const after = await status();

    const warm = samples.slice(Math.floor(samples.length * WARM_UP_SHARE));
    const half = Math.floor(warm.length / 2);
    for (const what of ["gateway_mb", "heap_mb"] as const) {
      const first = middle(warm.slice(0, half).map((sample) => sample[what]));
      const last = middle(warm.slice(half).map((sample) => sample[what]));
      console.log(`${what}: ${first.toFixed(1)} then ${last.toFixed(1)}`);
      expect(last, `${what} grows`).toBeLessThan(first * 1.05 + 1);
    }
    expect(after.board.frames_damaged).toBe(before.board.frames_damaged);
    expect(after.simulator.datagrams_dropped).toBe(before.simulator.datagrams_dropped);
    expect(after.alarms).toEqual([]);
    expect(said).toEqual([]);
    for (const name of readdirSync(path.join(data, "logs"))) {
      const lines = readFileSync(path.join(data, "logs", name), "utf8").split("\n");
      expect(
        lines.filter((line) => /error|warning|traceback|critical/i.test(line)),
        name,
      ).toEqual([]);
    }
  } finally {
    await launcher.stop("SIGINT");
    await rm(data, { recursive: true, force: true });
  }
});
