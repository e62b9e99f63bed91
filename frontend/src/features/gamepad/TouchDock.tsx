import { X } from "lucide-react";
import { type PointerEvent, type RefObject, useCallback, useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { useStickIsMine, useStickKind } from "../../readouts/useStick";
import { useCommandEntry, usePage, usePart } from "../../store/hooks";
import type { TelemetryStore } from "../../store/telemetry";
import { usePaint } from "../../store/usePaint";
import { Button } from "../../ui/Button";
import { onDialogs } from "../../ui/openDialogs";
import { GAMEPADS } from "./gamepadList";
import { TOUCH_PAD, TOUCH_STICK, TRAVEL_PX } from "./touchStick";
import { useTouchBlocked } from "./useGamepadBlocked";
import "./touch.css";

const FLY = { control: "stick", asked: "gamepad" } as const;

/** Docked under every tab: a stick for the simulator that flies for as long as a finger is on it. */
export function TouchDock() {
  const stick = usePart(TOUCH_STICK);
  const isOpen = useStore(stick.store, (state) => state.isOpen);
  return isOpen ? <Open /> : null;
}

function Open() {
  const { t } = useTranslation();
  const stick = usePart(TOUCH_STICK);
  const blocked = useTouchBlocked();
  const knobs = useKnobs();
  useLetGo(blocked);
  return (
    <section className="touch" aria-label={t("touchStick.title")}>
      <header className="touch-head">
        <h2 className="ui-panel-title">{t("touchStick.title")}</h2>
        <State blocked={blocked} />
        <Button
          onPress={() => stick.store.setState({ isOpen: false })}
          label={t("touchStick.close")}
          icon={<X size={16} aria-hidden="true" />}
        >
          {""}
        </Button>
      </header>
      <div className="touch-pads" data-blocked={blocked !== undefined}>
        <LeverPad knob={knobs.lever} paint={knobs.paint} />
        <StickPad knob={knobs.stick} paint={knobs.paint} isBlocked={blocked !== undefined} />
      </div>
    </section>
  );
}

/** In one sentence: why not, what is lost, who flies, or what to do. */
function State({ blocked }: { readonly blocked: string | undefined }) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const isHeld = useStore(usePart(TOUCH_STICK).store, (state) => state.isHeld);
  const isMine = useStickIsMine();
  const isLost = useStickKind() === "lost";
  const refusal = useCommandEntry("stick")?.message ?? null;
  const flies = isMine && isHeld && !isLost;
  const words =
    blocked ??
    (refusal?.level === "error"
      ? sentence(refusal)
      : t(flies ? "touchStick.flies" : isMine && isLost ? "touchStick.lost" : "touchStick.hint"));
  return (
    <p
      role="status"
      className="touch-state"
      data-state={flies ? "flies" : isMine && isLost ? "lost" : "rests"}
    >
      {words}
    </p>
  );
}

interface PadProps {
  readonly knob: RefObject<HTMLSpanElement | null>;
  /** Shows where both knobs stand. */
  readonly paint: () => void;
}

/** Aileron and elevator. The finger on it is what keeps the stick alive. */
function StickPad({ knob, paint, isBlocked }: PadProps & { readonly isBlocked: boolean }) {
  const { t } = useTranslation();
  const stick = usePart(TOUCH_STICK);
  const gamepads = usePart(GAMEPADS);
  const throttle = useFlownThrottle();
  const isMine = useStickIsMine();
  const pad = useFinger({
    press: (at) => {
      if (isBlocked) {
        return false;
      }
      stick.hold(at, throttle.current);
      if (!isMine) {
        gamepads.select(TOUCH_PAD);
        void gamepads.fly(FLY);
      }
      return true;
    },
    move: stick.move,
    leave: stick.letGo,
    paint,
  });
  return (
    <div className="touch-pad" data-pad="stick" {...pad}>
      <span className="touch-caption">{t("touchStick.stick")}</span>
      <span ref={knob} className="touch-knob" />
    </div>
  );
}

/** Throttle up and down, rudder across. */
function LeverPad({ knob, paint }: PadProps) {
  const { t } = useTranslation();
  const stick = usePart(TOUCH_STICK);
  const pad = useFinger({
    press: (at) => {
      stick.holdLever(at);
      return stick.store.getState().isHeld;
    },
    move: stick.moveLever,
    leave: stick.leaveLever,
    // Taken by the system and not lifted by the pilot: nobody knows what is meant, so nothing flies.
    taken: stick.letGo,
    paint,
  });
  return (
    <div className="touch-pad" data-pad="lever" {...pad}>
      <span className="touch-caption">{t("touchStick.lever")}</span>
      <span ref={knob} className="touch-knob" />
    </div>
  );
}

/** The power that flies now; none where it is not known. */
function useFlownThrottle(): RefObject<number> {
  const throttle = useRef(0);
  const read = useCallback((telemetry: TelemetryStore, now_ms: number) => {
    throttle.current = telemetry.liveNumber("xplane_info", "throttle", now_ms) ?? 0;
  }, []);
  usePaint("text", read);
  return throttle;
}

interface Finger {
  /** Whether the finger counts. */
  readonly press: (at: { x: number; y: number }) => boolean;
  readonly move: (to: { x: number; y: number }) => void;
  readonly leave: () => void;
  readonly taken?: () => void;
  readonly paint: () => void;
}

/** One finger on a pad: others beside it, and one that was let go meanwhile, count for nothing. */
function useFinger({ press, move, leave, taken = leave, paint }: Finger) {
  const finger = useRef<number | null>(null);
  const end = (run: () => void) => (event: PointerEvent) => {
    if (finger.current === event.pointerId) {
      finger.current = null;
      run();
      paint();
    }
  };
  return {
    onPointerDown: (event: PointerEvent<HTMLElement>) => {
      if (finger.current === null && event.button === 0 && press({ x: event.clientX, y: event.clientY })) {
        finger.current = event.pointerId;
        event.currentTarget.setPointerCapture(event.pointerId);
        paint();
      }
    },
    onPointerMove: (event: PointerEvent) => {
      if (finger.current === event.pointerId) {
        move({ x: event.clientX, y: event.clientY });
        paint();
      }
    },
    onPointerUp: end(leave),
    onPointerCancel: end(taken),
    onLostPointerCapture: end(taken),
    onContextMenu: (event: { preventDefault: () => void }) => event.preventDefault(),
  };
}

/** The knobs follow the fingers without a render. */
function useKnobs() {
  const touch = usePart(TOUCH_STICK);
  const stick = useRef<HTMLSpanElement>(null);
  const lever = useRef<HTMLSpanElement>(null);
  const paint = useRef(() => {
    const { aileron, elevator, rudder, throttle } = touch.position();
    place(stick.current, aileron * TRAVEL_PX, elevator * TRAVEL_PX);
    place(lever.current, rudder * TRAVEL_PX, (1 - 2 * throttle) * TRAVEL_PX);
  }).current;
  useEffect(() => {
    paint();
    return touch.store.subscribe(paint);
  }, [touch, paint]);
  return { stick, lever, paint };
}

function place(knob: HTMLElement | null, x_px: number, y_px: number): void {
  if (knob !== null) {
    knob.style.transform = `translate(${x_px}px, ${y_px}px)`;
  }
}

/**
 * Whatever takes the eye or the hand away from the stick lifts the finger: another window, a hidden page, a dialog, a reason
 * why it must not fly, the end of the dock. A finger that stays down counts again only after it was lifted.
 */
function useLetGo(blocked: string | undefined): void {
  const stick = usePart(TOUCH_STICK);
  const gamepads = usePart(GAMEPADS);
  const { connection } = usePage();
  useEffect(() => {
    if (blocked !== undefined) {
      stick.letGo();
    }
  }, [stick, blocked]);
  useEffect(() => {
    const { letGo } = stick;
    const cancelDialogs = onDialogs(letGo);
    const events = ["blur", "pagehide"] as const;
    for (const event of events) {
      window.addEventListener(event, letGo);
    }
    document.addEventListener("visibilitychange", letGo);
    return () => {
      cancelDialogs();
      for (const event of events) {
        window.removeEventListener(event, letGo);
      }
      document.removeEventListener("visibilitychange", letGo);
      letGo();
      const { status, client, phase } = connection.getState();
      const flying = status?.hil.stick;
      // Who puts the stick away gives it back; nobody is left with one that nobody holds.
      if (
        phase === "open" &&
        client !== null &&
        flying?.client === client &&
        flying.gamepad === TOUCH_PAD.id
      ) {
        void gamepads.flySimulator({ control: "stick", asked: "simulator" });
      }
    };
  }, [stick, gamepads, connection]);
}
