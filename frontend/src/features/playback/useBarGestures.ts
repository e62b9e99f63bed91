import { type PointerEvent, type RefObject, useEffect, useRef } from "react";
import { atOf, type BarView, panned, zoomed } from "./barGeometry";

interface Gestures {
  readonly bar: RefObject<HTMLElement | null>;
  readonly view: BarView;
  readonly edge_s: number;
  /** The hand is at this moment. */
  readonly onMoment: (at_s: number) => void;
  /** The hand has let go. */
  readonly onRelease: () => void;
  readonly onView: (view: BarView) => void;
}

interface Handlers {
  readonly onPointerDown: (event: PointerEvent) => void;
  readonly onPointerMove: (event: PointerEvent) => void;
  readonly onPointerUp: (event: PointerEvent) => void;
  readonly onPointerCancel: (event: PointerEvent) => void;
}

/** A finger may tremble so far before it is a drag: two fingers never come down at once. */
const TREMBLE_PX = 4;
const ZOOM_PER_PIXEL = 1.0015;

/** One pointer drags the moment, two pinch and drag the view; the wheel zooms, with Shift it moves the view. */
export function useBarGestures({ bar, view, edge_s, onMoment, onRelease, onView }: Gestures): Handlers {
  const newest = useRef({ view, edge_s, onMoment, onRelease, onView });
  useEffect(() => {
    newest.current = { view, edge_s, onMoment, onRelease, onView };
  });
  const pointers = useRef(new Map<number, number>());
  /** Where a finger came down that has not moved yet. */
  const resting = useRef<number | null>(null);
  /** Two fingers came down: until both are up, none of them drags the moment. */
  const isPinch = useRef(false);

  useEffect(() => {
    const element = bar.current;
    if (element === null) {
      return undefined;
    }
    const wheel = (event: WheelEvent): void => {
      event.preventDefault();
      const { view: now, edge_s: edge, onView: change } = newest.current;
      const { left, width } = element.getBoundingClientRect();
      const span_s = now.to_s - now.from_s;
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
        change(panned(now, ((event.deltaX || event.deltaY) / Math.max(1, width)) * span_s, edge));
      } else {
        change(zoomed(now, atOf(event.clientX - left, now, width), ZOOM_PER_PIXEL ** event.deltaY, edge));
      }
    };
    // React's own listener could not keep the page from scrolling.
    element.addEventListener("wheel", wheel, { passive: false });
    return () => element.removeEventListener("wheel", wheel);
  }, [bar]);

  function momentAt(x: number): void {
    const element = bar.current;
    if (element !== null) {
      const { left, width } = element.getBoundingClientRect();
      newest.current.onMoment(atOf(x - left, newest.current.view, width));
    }
  }

  function pinch(id: number, x: number): void {
    const element = bar.current;
    const other = [...pointers.current].find(([pointer]) => pointer !== id)?.[1];
    const before = pointers.current.get(id);
    if (element === null || other === undefined || before === undefined) {
      return;
    }
    const { left, width } = element.getBoundingClientRect();
    const { view: now, edge_s: edge, onView: change } = newest.current;
    const apart_px = Math.max(10, Math.abs(x - other));
    const apartBefore_px = Math.max(10, Math.abs(before - other));
    const middle_s = atOf((before + other) / 2 - left, now, width);
    const next = zoomed(now, middle_s, apartBefore_px / apart_px, edge);
    const shift_s = ((before - x) / 2 / Math.max(1, width)) * (next.to_s - next.from_s);
    change(panned(next, shift_s, edge));
  }

  function end(event: PointerEvent): void {
    if (pointers.current.delete(event.pointerId) && resting.current !== null) {
      if (event.type === "pointerup") {
        momentAt(event.clientX);
      }
      resting.current = null;
    }
    isPinch.current &&= pointers.current.size > 0;
    if (pointers.current.size === 0) {
      newest.current.onRelease();
    }
  }

  return {
    onPointerDown: (event) => {
      if (event.button !== 0) {
        return;
      }
      event.currentTarget.setPointerCapture?.(event.pointerId);
      pointers.current.set(event.pointerId, event.clientX);
      if (pointers.current.size > 1) {
        resting.current = null;
        isPinch.current = true;
      } else if (event.pointerType === "touch") {
        resting.current = event.clientX;
      } else {
        momentAt(event.clientX);
      }
    },
    onPointerMove: (event) => {
      if (!pointers.current.has(event.pointerId)) {
        return;
      }
      if (pointers.current.size > 1) {
        pinch(event.pointerId, event.clientX);
      } else if (
        !isPinch.current &&
        (resting.current === null || Math.abs(event.clientX - resting.current) > TREMBLE_PX)
      ) {
        resting.current = null;
        momentAt(event.clientX);
      }
      pointers.current.set(event.pointerId, event.clientX);
    },
    onPointerUp: end,
    onPointerCancel: end,
  };
}
