import { GripVertical } from "lucide-react";
import {
  type CSSProperties,
  createContext,
  type KeyboardEvent,
  type PointerEvent,
  type ReactNode,
  type RefObject,
  useContext,
  useEffect,
  useRef,
  useState,
} from "react";
import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { AnchoredMenu, MenuChoice } from "../../ui/MenuBar";
import { Toolbar } from "../../ui/Toolbar";
import { EDGES, edgeAt, floatingAt, movedBy, type Place, placeText, readPlace } from "./places";
import "./toolbars.css";

export function usePlace(name: string): Place {
  const text = useSettings(({ choices }) => choices[placeKey(name)]);
  return readPlace(text);
}

export function placeKey(name: string): string {
  return `toolbar.${name}`;
}

/**
 * The toolbar moved last. At another edge it is a new element, whose handle must take over the focus of the old one.
 */
export const MovedContext = createContext<RefObject<string | null>>({ current: null });

/** Movement up to this many pixels is a click, not a drag. */
const SLIP_PX = 5;

interface Drag {
  readonly startX: number;
  readonly startY: number;
  /** Offset of the pointer from the toolbar's corner. */
  readonly grabX: number;
  readonly grabY: number;
  isMoving: boolean;
}

interface Props {
  name: string;
  label: string;
  children: ReactNode;
}

/** A toolbar with a handle that moves it to an edge or anywhere: by dragging, arrow keys or the handle's menu. */
export function MovableToolbar({ name, label, children }: Props) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const place = usePlace(name);
  const moved = useContext(MovedContext);
  const bar = useRef<HTMLDivElement>(null);
  const handle = useRef<HTMLButtonElement>(null);
  const drag = useRef<Drag | null>(null);
  const wasDragged = useRef(false);
  const [isMenuOpen, setMenuOpen] = useState(false);

  useEffect(() => {
    if (moved.current === name) {
      moved.current = null;
      handle.current?.focus();
    }
  }, [moved, name]);

  function put(next: Place): void {
    moved.current = name;
    choose(settings, placeKey(name), placeText(next));
  }

  function onKeyDown(event: KeyboardEvent): void {
    const next = movedBy(event.key, place);
    if (next !== null) {
      event.preventDefault();
      put(next);
    }
  }

  function onPointerDown(event: PointerEvent<HTMLButtonElement>): void {
    if (event.button !== 0 || bar.current === null) {
      return;
    }
    const { left, top } = bar.current.getBoundingClientRect();
    event.currentTarget.setPointerCapture(event.pointerId);
    wasDragged.current = false;
    drag.current = {
      startX: event.clientX,
      startY: event.clientY,
      grabX: event.clientX - left,
      grabY: event.clientY - top,
      isMoving: false,
    };
  }

  function onPointerMove(event: PointerEvent): void {
    const held = drag.current;
    if (held === null || bar.current === null) {
      return;
    }
    held.isMoving ||= Math.hypot(event.clientX - held.startX, event.clientY - held.startY) > SLIP_PX;
    if (held.isMoving) {
      const { style, dataset } = bar.current;
      dataset["dragged"] = edgeAt({ x: event.clientX, y: event.clientY }, windowSize()) ?? "floating";
      style.left = `${event.clientX - held.grabX}px`;
      style.top = `${event.clientY - held.grabY}px`;
    }
  }

  function onPointerUp(event: PointerEvent): void {
    const held = letGo();
    if (held?.isMoving !== true || bar.current === null) {
      return;
    }
    wasDragged.current = true;
    const corner = { x: event.clientX - held.grabX, y: event.clientY - held.grabY };
    const edge = edgeAt({ x: event.clientX, y: event.clientY }, windowSize());
    put(edge === null ? floatingAt(corner, bar.current.getBoundingClientRect(), windowSize()) : { edge });
  }

  /** End the drag and remove its inline styles. */
  function letGo(): Drag | null {
    const held = drag.current;
    drag.current = null;
    if (bar.current !== null) {
      delete bar.current.dataset["dragged"];
      bar.current.style.removeProperty("left");
      bar.current.style.removeProperty("top");
    }
    return held;
  }

  const isFloating = !("edge" in place);
  return (
    <div
      ref={bar}
      className="app-movable"
      data-place={isFloating ? "floating" : place.edge}
      style={isFloating ? ({ "--x": place.x, "--y": place.y } as CSSProperties) : undefined}
    >
      <button
        ref={handle}
        type="button"
        className="app-handle"
        aria-label={t("place.handle", { toolbar: label })}
        aria-haspopup="menu"
        aria-expanded={isMenuOpen}
        title={t("place.hint")}
        onKeyDown={onKeyDown}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onPointerUp}
        onPointerCancel={letGo}
        // Ignore the click that ends a drag.
        onClick={() => wasDragged.current || setMenuOpen((open) => !open)}
      >
        <GripVertical size={14} aria-hidden="true" />
      </button>
      <Toolbar label={label}>{children}</Toolbar>
      {isMenuOpen && (
        <AnchoredMenu anchor={handle} home={bar} onClose={() => setMenuOpen(false)}>
          <MenuChoice
            label={label}
            options={[...EDGES, "floating" as const].map((value) => ({ value, label: t(`place.${value}`) }))}
            value={isFloating ? "floating" : place.edge}
            onChange={(value) => {
              setMenuOpen(false);
              put(value === "floating" ? { x: 0.5, y: 0.3 } : { edge: value });
            }}
          />
        </AnchoredMenu>
      )}
    </div>
  );
}

function windowSize(): { width: number; height: number } {
  return { width: window.innerWidth, height: window.innerHeight };
}
