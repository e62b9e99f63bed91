import type { Settings } from "../store/settings";

/** As the system asks for, or little in any case. */
export const MOTION = ["system", "less"] as const;
export type Motion = (typeof MOTION)[number];

export function motionOf({ choices }: Settings): Motion {
  return MOTION.find((motion) => motion === choices["motion"]) ?? "system";
}
