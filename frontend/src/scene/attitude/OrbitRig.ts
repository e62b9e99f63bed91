import { PerspectiveCamera, Vector3 } from "three";

export const CAMERA_VIEWS = ["behind", "front", "top", "side"] as const;
export type CameraView = (typeof CAMERA_VIEWS)[number];

/** Each view's place: degrees clockwise from behind the aircraft, and above its horizon. */
const PLACES: Readonly<Record<CameraView, readonly [round_deg: number, up_deg: number]>> = {
  behind: [0, 16],
  front: [180, 12],
  top: [0, 89.5],
  side: [-90, 8],
};

const FIELD_DEG = 34;
/** So near that from behind the rose's nearest letter is just visible. */
const DISTANCE = 8;
const NEAREST = 3;
const FARTHEST = 18;
const DEGREES_PER_PIXEL = 0.4;
const DEGREES_PER_KEY = 7.5;
const ZOOM_PER_KEY = 1.12;
const HIGHEST_DEG = 89.5;

/**
 * A camera on a sphere around the middle of the scene. It is put to a named view relative to a heading, and turned by
 * dragging, wheel and keys. `onChange` is called for every movement by the user, `onFree` when the user leaves the
 * named view.
 */
export class OrbitRig {
  readonly camera = new PerspectiveCamera(FIELD_DEG, 1, 0.1, 60);
  onChange: (() => void) | null = null;
  onFree: (() => void) | null = null;
  readonly #target: Vector3;
  #round_deg: number;
  #up_deg: number;
  #distance = DISTANCE;
  /** The heading that the view from behind looks along. */
  #ahead_deg = 0;

  constructor(target: readonly [number, number, number] = [0, -0.25, 0]) {
    this.#target = new Vector3(...target);
    [this.#round_deg, this.#up_deg] = PLACES.behind;
  }

  /** Go to a named view; from behind it looks along `ahead_deg`. */
  place(view: CameraView, ahead_deg: number): void {
    [this.#round_deg, this.#up_deg] = PLACES[view];
    this.#distance = DISTANCE;
    this.#ahead_deg = ahead_deg;
  }

  /** Turn with the aircraft's heading. */
  follow(ahead_deg: number): void {
    this.#ahead_deg = ahead_deg;
  }

  /** Apply the camera's position; in a narrow picture it is farther away. */
  settle(): void {
    const course = ((this.#ahead_deg + 180 + this.#round_deg) * Math.PI) / 180;
    const up = (this.#up_deg * Math.PI) / 180;
    const distance = this.#distance * Math.max(1, 1.125 / this.camera.aspect);
    const level = Math.cos(up) * distance;
    this.camera.position.set(
      this.#target.x + Math.sin(course) * level,
      this.#target.y + Math.sin(up) * distance,
      this.#target.z - Math.cos(course) * level,
    );
    this.camera.lookAt(this.#target);
    this.camera.updateMatrixWorld();
  }

  /** Let the user turn it on this element; returns a function that ends that. */
  listen(element: HTMLElement): () => void {
    const events = new AbortController();
    const { signal } = events;
    element.addEventListener("pointerdown", (event) => this.#press(element, event), { signal });
    element.addEventListener("pointermove", (event) => this.#drag(element, event), { signal });
    element.addEventListener("wheel", (event) => this.#wheel(event), { signal, passive: false });
    element.addEventListener("keydown", (event) => this.#key(event), { signal });
    return () => events.abort();
  }

  #press(element: HTMLElement, event: PointerEvent): void {
    if (event.button === 0) {
      element.setPointerCapture(event.pointerId);
    }
  }

  #drag(element: HTMLElement, event: PointerEvent): void {
    if (element.hasPointerCapture(event.pointerId)) {
      this.#turn(-event.movementX * DEGREES_PER_PIXEL, event.movementY * DEGREES_PER_PIXEL);
    }
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    this.#zoom(Math.exp(Math.sign(event.deltaY) * 0.1));
  }

  #key(event: KeyboardEvent): void {
    const moves: Readonly<Record<string, () => void>> = {
      ArrowLeft: () => this.#turn(DEGREES_PER_KEY, 0),
      ArrowRight: () => this.#turn(-DEGREES_PER_KEY, 0),
      ArrowUp: () => this.#turn(0, DEGREES_PER_KEY),
      ArrowDown: () => this.#turn(0, -DEGREES_PER_KEY),
      PageUp: () => this.#zoom(1 / ZOOM_PER_KEY),
      PageDown: () => this.#zoom(ZOOM_PER_KEY),
    };
    const move = moves[event.key];
    if (move !== undefined && !event.ctrlKey && !event.altKey && !event.metaKey) {
      event.preventDefault();
      move();
    }
  }

  #turn(round_deg: number, up_deg: number): void {
    this.#round_deg = (this.#round_deg + round_deg) % 360;
    this.#up_deg = Math.max(-HIGHEST_DEG, Math.min(HIGHEST_DEG, this.#up_deg + up_deg));
    this.onFree?.();
    this.onChange?.();
  }

  #zoom(factor: number): void {
    this.#distance = Math.max(NEAREST, Math.min(FARTHEST, this.#distance * factor));
    this.onChange?.();
  }
}
