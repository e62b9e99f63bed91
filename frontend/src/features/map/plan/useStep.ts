import { useSettings } from "../../../store/hooks";

/** Step sizes of the buttons and keys that move a waypoint: metres along the ground, feet upwards. */
export const STEPS = { "1": 1, "10": 10, "100": 100 } as const;
export type Step = keyof typeof STEPS;
export const STEP_CHOICE = "map.plan.step";

export function useStepChoice(): Step {
  return useSettings(
    ({ choices }) => (Object.keys(STEPS) as Step[]).find((known) => known === choices[STEP_CHOICE]) ?? "10",
  );
}

export function useStep(): number {
  return STEPS[useStepChoice()];
}
