import type { Settings } from "../store/settings";

/** `system`: as the operating system asks. `less`: always reduced motion. */
export const MOTION = ["system", "less"] as const;
export type Motion = (typeof MOTION)[number];

export function motionOf({ choices }: Settings): Motion {
  return MOTION.find((motion) => motion === choices["motion"]) ?? "system";
}
