export type DeviceKind = "phone" | "tablet" | "laptop";

interface Screen {
  readonly navigator: { readonly maxTouchPoints: number };
  readonly screen: { readonly width: number; readonly height: number };
}

/** Shorter sides of a screen in CSS pixels: a phone has less, a tablet more. */
const TABLET_PX = 600;

/** What this page probably runs on, as a first word for its place; people correct it. */
export function deviceKind({ navigator, screen }: Screen): DeviceKind {
  if (navigator.maxTouchPoints === 0) {
    return "laptop";
  }
  return Math.min(screen.width, screen.height) < TABLET_PX ? "phone" : "tablet";
}
