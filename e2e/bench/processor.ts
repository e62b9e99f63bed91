import { readdirSync, readFileSync } from "node:fs";

const CLOCK_TICKS_PER_S = 100;

/** Processor time of the browser that this process started, seconds since its start. */
export type Used = {
  /** All of its processes. */
  browser: number;
  /** The one that draws what is drawn in 3D, and puts the page's picture together. */
  graphics: number;
};

/** Every process below this one but the tools that drive it. */
export function browserSeconds(): Used {
  const parents = new Map<number, number>();
  const found = new Map<number, { seconds: number; isGraphics: boolean }>();
  for (const name of readdirSync("/proc")) {
    if (!/^\d+$/.test(name)) continue;
    try {
      const [head = "", rest = ""] = readFileSync(`/proc/${name}/stat`, "utf8").split(/\) (?=\w )/);
      const fields = rest.split(" ");
      parents.set(Number(name), Number(fields[1]));
      if (/chrom|headless/i.test(head)) {
        found.set(Number(name), {
          seconds: (Number(fields[11]) + Number(fields[12])) / CLOCK_TICKS_PER_S,
          isGraphics: readFileSync(`/proc/${name}/cmdline`, "utf8").includes("--type=gpu-process"),
        });
      }
    } catch {
      // a process that has just ended
    }
  }
  const isOurs = (pid: number): boolean => {
    for (let at: number | undefined = pid; at !== undefined && at > 1; at = parents.get(at)) {
      if (at === process.pid) return true;
    }
    return false;
  };
  const used = { browser: 0, graphics: 0 };
  for (const [pid, { seconds, isGraphics }] of found) {
    if (isOurs(pid)) {
      used.browser += seconds;
      used.graphics += isGraphics ? seconds : 0;
    }
  }
  return used;
}
