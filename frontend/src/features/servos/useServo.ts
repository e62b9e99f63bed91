import { useStore } from "zustand";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import type { Servo } from "./servoPositions";
import { SERVO_SLIDERS, UNMOVED } from "./servoPositions";

/** One servo output's slider; it renders again only when it changes. */
export function useServo(index: number): Servo {
  return useStore(usePart(SERVO_SLIDERS).store, ({ servos }) => servos[index] ?? UNMOVED);
}

/** Why a servo output did not move, while a slider shows it. */
export function useServoFailure(): Message | null {
  return useStore(
    usePart(SERVO_SLIDERS).store,
    ({ servos }) => servos.find(({ message }) => message !== null)?.message ?? null,
  );
}
