import {
  Cartesian3,
  Math as CesiumMath,
  CesiumWidget,
  Clock,
  Color,
  Credit,
  CreditDisplay,
  JulianDate,
  type Scene,
} from "@cesium/engine";
import { tellTiming } from "../../lib/timing";
import { CopiedPicture } from "../CopiedPicture";
import { FrameBudget } from "../frameBudget";
import { drawsInSoftware, FrameCost } from "../graphics";
import { globeLimits, softwareScale } from "./globeBudget";
import { Ground } from "./ground";
import { hastenTiles, setQuality, setScale } from "./quality";

/** The one day that the globe shows: without day and night there is nothing to fetch for another. */
const NOON = "2026-06-21T13:00:00Z";
const SKY = "#8fb6d3";
/** After the wheel was turned, the globe is in a hand for so long. */
const WHEEL_MS = 400;
/** Nothing has moved for so long: longer than between two ages in words, which come each second. */
const REST_MS = 1500;
/** A frame in which shaders were made takes seconds, and says nothing of the next ones. */
const MOST_MS = 500;
/** Kept until it is copied, long after it was drawn; ground smoothed along the view would cost several times as much. */
const softwareContext = () => ({
  allowTextureFilterAnisotropic: false,
  webgl: { antialias: false, preserveDrawingBuffer: true },
});

/**
 * The globe, made once for the page's life and moved between its place and nowhere: a browser has only so many
 * graphics contexts. It is drawn when somebody has asked for it (`requestRender`), as often as the budget allows.
 *
 * Heights: telemetry tells heights over mean sea level, Cesium takes heights over the ellipsoid. Here the ellipsoid is
 * the sea: heights over sea level are used as they are, for the aircraft, plans and terrain alike, and agree with each
 * other. (The geoid's 40 to 50 m at the Canary Islands are left out everywhere.)
 */
export class Globe {
  readonly widget: CesiumWidget;
  readonly scene: Scene;
  readonly ground: Ground;
  /** It is drawn by the processor alone: coarser while something moves. */
  readonly isSoftware = drawsInSoftware();
  readonly #element = document.createElement("div");
  readonly #listeners = new Set<(now_ms: number) => void>();
  readonly #owned = new Set<() => void>();
  readonly #budget: FrameBudget;
  readonly #cost: FrameCost;
  #handle: number | null = null;
  #ticked_ms = Number.NEGATIVE_INFINITY;
  readonly #copied: CopiedPicture | null;
  #isDear: boolean | null = null;
  /** Something was asked to be drawn since the last frame. */
  #isAsked = false;
  /** The picture is coarser than at rest. */
  #isCoarse = true;
  #drawn_ms = Number.NEGATIVE_INFINITY;
  #isHeld = false;
  #wheeled_ms = Number.NEGATIVE_INFINITY;
  #drawn = 0;

  /** `onLost`: the browser has taken the graphics away; this globe is of no use any more. Throws where there is no WebGL. */
  constructor(onLost: () => void = () => undefined) {
    // Its default is a picture of its maker, fetched with the first frame. It is named in the page's own words instead.
    CreditDisplay.cesiumCredit = new Credit("");
    this.#element.className = "globe";
    this.widget = new CesiumWidget(this.#element, {
      clock: new Clock({ currentTime: JulianDate.fromIso8601(NOON), shouldAnimate: false }),
      baseLayer: false,
      skyBox: false,
      skyAtmosphere: false,
      scene3DOnly: true,
      useDefaultRenderLoop: false,
      showRenderLoopErrors: false,
      requestRenderMode: true,
      maximumRenderTimeChange: Number.POSITIVE_INFINITY,
      msaaSamples: 1,
      // What shines through is sorted by distance instead, which spares three more pictures a frame.
      orderIndependentTranslucency: false,
      creditContainer: document.createElement("div"),
      blurActiveElementOnCanvasFocus: false,
      automaticallyTrackDataSourceClocks: false,
      ...(this.isSoftware && { contextOptions: softwareContext() }),
    });
    this.scene = this.widget.scene;
    this.scene.backgroundColor = Color.fromCssColorString(SKY);
    this.scene.canvas.classList.add("globe-picture");
    this.#copied = this.isSoftware ? this.#seenBy(this.scene.canvas) : null;
    this.#cost = new FrameCost(this.scene.canvas.getContext("webgl2"), "globe.frame");
    this.#budget = new FrameBudget(this.isSoftware, globeLimits(this.isSoftware));
    this.ground = new Ground(this);
    this.scene.camera.setView({
      destination: Cartesian3.fromDegrees(-15.3, 27.75, 25_000),
      orientation: { heading: CesiumMath.toRadians(-12), pitch: CesiumMath.toRadians(-40), roll: 0 },
    });
    this.scene.canvas.addEventListener("webglcontextlost", onLost, { once: true });
    this.#watchHands();
  }

  /** Where it is shown; null while it is not. */
  get host(): HTMLElement | null {
    return this.#element.parentElement;
  }

  /** Frames drawn since it was made. */
  get drawn(): number {
    return this.#drawn;
  }

  /** Something has just been moving in it: drawn by the processor alone, it is coarser than at rest. */
  get isMoving(): boolean {
    return this.#isCoarse;
  }

  /** Show it in `host`; it is drawn only while it is shown. */
  attach(host: HTMLElement): void {
    host.append(this.#element);
    // It is turned by keys.
    host.tabIndex = 0;
    this.#ticked_ms = Number.NEGATIVE_INFINITY;
    this.requestRender();
    this.#handle ??= requestAnimationFrame(this.#tick);
  }

  detach(): void {
    this.#element.remove();
    if (this.#handle !== null) {
      cancelAnimationFrame(this.#handle);
      this.#handle = null;
    }
  }

  /** Something has changed: draw it when the budget allows. */
  requestRender(): void {
    this.#isAsked = true;
    this.scene.requestRender();
  }

  /** Called before each frame that may be drawn; who moves something there calls `requestRender`. */
  onBeforeFrame(listener: (now_ms: number) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Called when it goes, before its scene does. */
  onDispose(listener: () => void): void {
    this.#owned.add(listener);
  }

  dispose(): void {
    this.detach();
    for (const end of this.#owned) {
      end();
    }
    this.#listeners.clear();
    this.widget.destroy();
  }

  readonly #tick = (now_ms: number): void => {
    this.#handle = requestAnimationFrame(this.#tick);
    this.#settle();
    const isHeld = this.#isHeld || now_ms - this.#wheeled_ms < WHEEL_MS;
    // Never two frames on their way: the page would wait for the graphics, and its instruments with it.
    if (this.#cost.isWaiting || now_ms - this.#ticked_ms < this.#budget.period_ms(isHeld)) {
      return;
    }
    this.#ticked_ms = now_ms;
    this.#suitQuality();
    for (const listener of this.#listeners) {
      listener(now_ms);
    }
    if (this.isSoftware) {
      this.#suitScale(isHeld, now_ms);
    }
    this.widget.resize();
    const before = this.#frameNumber();
    const started_ms = this.#cost.start();
    this.widget.render();
    if (this.#frameNumber() !== before) {
      this.#isAsked = false;
      this.#drawn_ms = now_ms;
      this.#drawn += 1;
      this.#cost.finish();
      tellTiming("globe.script", started_ms);
    }
  };

  #settle(): void {
    const cost_ms = this.#cost.settle();
    if (cost_ms === null) {
      return;
    }
    if (this.#copied !== null) {
      this.#copied.copy();
      hastenTiles(this.scene, cost_ms);
    }
    // A fine picture of all at rest says nothing of the next that moves.
    if (this.#isCoarse || !this.isSoftware) {
      this.#budget.observe(Math.min(cost_ms, MOST_MS));
    }
  }

  #suitQuality(): void {
    if (this.#isDear !== this.#budget.isDear) {
      this.#isDear = this.#budget.isDear;
      setQuality(this.widget, this.#isDear);
      this.requestRender();
    }
  }

  /** Coarse from the first movement on; fine again when nothing was drawn for a while. Pictures of the ground change nothing. */
  #suitScale(isHeld: boolean, now_ms: number): void {
    if (this.#isAsked || isHeld) {
      this.#isCoarse = true;
    } else if (this.#isCoarse && now_ms - this.#drawn_ms > REST_MS) {
      this.#isCoarse = false;
      this.scene.requestRender();
    }
    const { clientWidth, clientHeight } = this.scene.canvas;
    setScale(this.widget, softwareScale(clientWidth, clientHeight, this.#isCoarse));
  }

  #frameNumber(): number {
    // Not in its published types; nothing else tells whether a frame was drawn.
    return (this.scene as unknown as { frameState: { frameNumber: number } }).frameState.frameNumber;
  }

  /** The picture itself is not seen, but still takes the pointer's presses. */
  #seenBy(picture: HTMLCanvasElement): CopiedPicture {
    const copied = new CopiedPicture(picture);
    copied.canvas.className = "globe-picture";
    picture.before(copied.canvas);
    picture.classList.replace("globe-picture", "globe-unseen");
    return copied;
  }

  #watchHands(): void {
    this.#element.addEventListener("pointerdown", () => {
      this.#isHeld = true;
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
      this.#element.addEventListener(end, () => {
        this.#isHeld = false;
      });
    }
    this.#element.addEventListener(
      "wheel",
      () => {
        this.#wheeled_ms = performance.now();
      },
      { passive: true },
    );
  }
}
