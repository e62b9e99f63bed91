import { useEffect, useSyncExternalStore } from "react";

/**
 * How the window is laid out.
 * - `wide`: menus, toolbars, left panel, tabs above their content: a laptop or more.
 * - `column`: one column, the instruments above the open tab, the tabs in a bar at the bottom: a phone or a tablet held
 *   upright, and any window that is zoomed far.
 * - `beside`: the instruments at the left, the tabs in a rail at the right: the same held sideways.
 */
export type Layout = "wide" | "column" | "beside";

/** Narrow, low, or touched without room for fingers in the wide layout. A rem here is the browser's own, 16 px. */
const COMPACT = "(width < 56rem), (height < 34rem), ((pointer: coarse) and (width < 75rem))";
const BESIDE = "(orientation: landscape) and (width >= 36rem)";

function now(): Layout {
  // Without media queries (a document without a screen) nothing is known of the window.
  if (typeof window.matchMedia !== "function" || !window.matchMedia(COMPACT).matches) {
    return "wide";
  }
  return window.matchMedia(BESIDE).matches ? "beside" : "column";
}

function onChange(run: () => void): () => void {
  if (typeof window.matchMedia !== "function") {
    return () => undefined;
  }
  const queries = [COMPACT, BESIDE].map((query) => window.matchMedia(query));
  for (const query of queries) {
    query.addEventListener("change", run);
  }
  return () => {
    for (const query of queries) {
      query.removeEventListener("change", run);
    }
  };
}

/** The present layout; follows the window. */
export function useLayout(): Layout {
  return useSyncExternalStore(onChange, now);
}

/** Tells style sheets the layout, also for dialogs and menus, which are outside of the window's element. */
export function useLayoutOnDocument(layout: Layout): void {
  useEffect(() => {
    document.documentElement.dataset["layout"] = layout;
  }, [layout]);
}
