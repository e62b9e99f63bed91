import { type RefObject, useEffect } from "react";

/** While not all of an element is in sight it takes the focus, so that the keyboard alone can scroll it. */
export function useScrolledByKey(element: RefObject<HTMLElement | null>): void {
  useEffect(() => {
    const box = element.current;
    if (box === null || typeof ResizeObserver === "undefined") {
      return;
    }
    const look = () => {
      if (box.scrollHeight > box.clientHeight) {
        box.tabIndex = 0;
      } else {
        box.removeAttribute("tabindex");
      }
    };
    const observer = new ResizeObserver(look);
    for (const part of [box, ...box.children]) {
      observer.observe(part);
    }
    return () => observer.disconnect();
  }, [element]);
}
