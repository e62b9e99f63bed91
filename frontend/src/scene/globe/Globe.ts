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
import { GuardedCalls } from "../../lib/guardedCalls";
import { tellTiming } from "../../lib/timers";
import { CopiedPicture } from "../CopiedPicture";
import { drawsInSoftware, PictureCost } from "../graphics";
import { PictureBudget } from "../pictureBudget";
import { GlobeLabels } from "./GlobeLabels";
import { globeLimits, softwareScale } from "./globeBudget";
import { Ground } from "./ground";
import { hastenTiles, setQuality, setScale } from "./quality";

/** The globe always shows this day: without day and night nothing else needs to be loaded. */
const NOON = "2026-06-21T13:00:00Z";
/** For this long after the wheel was turned, the user counts as moving the globe. */
const WHEEL_MS = 400;
/**
 * The globe is at rest when nothing has moved for this long: longer than the second between two updates of the ages.
 */
const REST_MS = 1500;
/** A longer picture was one in which shaders were compiled: it says nothing about the next ones. */
const MOST_MS = 500;
/**
 * The buffer is kept until it is copied, long after it was drawn. Anisotropic filtering of the ground would cost
 * several times as much.
 */
const softwareContext = () => ({
  allowTextureFilterAnisotropic: false,
  webgl: { alpha: true, antialias: false, preserveDrawingBuffer: true },
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
  readonly labels: GlobeLabels;
  /** Drawn without a graphics processor: coarser while something moves. */
  readonly isSoftware = drawsInSoftware();
  readonly #element = document.createElement("div");
  readonly #listeners = new Set<(now_ms: number) => void>();
  readonly #calls = new GuardedCalls((error) => reportError(error));
  readonly #owned = new Set<() => void>();
  readonly #budget: PictureBudget;
  readonly #cost: PictureCost;
  #handle: number | null = null;
  #ticked_ms = Number.NEGATIVE_INFINITY;
  readonly #copied: CopiedPicture | null;
  #isDear: boolean | null = null;
  /** A new picture was requested since the last one. */
  #isAsked = false;
  /** The picture is coarser than at rest. */
  #isCoarse = true;
  #drawn_ms = Number.NEGATIVE_INFINITY;
  #isHeld = false;
  #wheeled_ms = Number.NEGATIVE_INFINITY;
  #drawn = 0;

  /**
   * `onLost`: the browser has taken the graphics context away and this globe cannot be used any more. Throws without
   * WebGL.
   */
  constructor(onLost: () => void = () => undefined) {
    // The default credit is a logo that would be fetched with the first picture; the maker is credited in the page's
    // own text instead.
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
      // Translucent parts are sorted by distance instead, which saves three more passes per picture.
      orderIndependentTranslucency: false,
      creditContainer: document.createElement("div"),
      blurActiveElementOnCanvasFocus: false,
      automaticallyTrackDataSourceClocks: false,
      // The sky is a canvas of its own behind the picture.
      contextOptions: this.isSoftware ? softwareContext() : { webgl: { alpha: true } },
    });
    this.scene = this.widget.scene;
    this.scene.backgroundColor = Color.TRANSPARENT;
    this.scene.canvas.classList.add("globe-picture");
    this.#copied = this.isSoftware ? this.#seenBy(this.scene.canvas) : null;
    this.#cost = new PictureCost(this.scene.canvas.getContext("webgl2"), "globe.picture");
    this.#budget = new PictureBudget(this.isSoftware, globeLimits(this.isSoftware));
    this.ground = new Ground(this);
    this.labels = new GlobeLabels(this.scene, this.#element);
    this.scene.camera.setView({
      destination: Cartesian3.fromDegrees(-15.3, 27.75, 25_000),
      orientation: { heading: CesiumMath.toRadians(-12), pitch: CesiumMath.toRadians(-40), roll: 0 },
    });
    this.scene.canvas.addEventListener("webglcontextlost", onLost, { once: true });
    this.#watchHands();
  }

  /** The element in which it is shown; null if it is not. */
  get host(): HTMLElement | null {
    return this.#element.parentElement;
  }

  /** Number of pictures drawn. */
  get drawn(): number {
    return this.#drawn;
  }

  /** Something has moved recently: without a graphics processor it is coarser than at rest. */
  get isMoving(): boolean {
    return this.#isCoarse;
  }

  /** Show it in `host`; it is drawn only while it is shown. */
  attach(host: HTMLElement): void {
    host.append(this.#element);
    // Focusable, for the keys that turn it.
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

  /** Request a new picture, drawn when the budget allows. */
  requestRender(): void {
    this.#isAsked = true;
    this.scene.requestRender();
  }

  /** The texts have changed, and the picture below them has not. */
  repaintLabels(): void {
    if (this.#drawn > 0 && !this.#cost.isWaiting) {
      this.labels.arrange();
      this.labels.paint();
    }
  }

  /** Called before each picture; a listener that moves something calls `requestRender`. */
  onBeforePicture(listener: (now_ms: number) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Called when it is disposed of, before its scene is. */
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
    // Never two pending pictures: the page would wait for the graphics, and its instruments with it.
    if (this.#cost.isWaiting || now_ms - this.#ticked_ms < this.#budget.period_ms(isHeld)) {
      return;
    }
    this.#ticked_ms = now_ms;
    this.#suitQuality();
    this.#calls.each(this.#listeners, (listener) => listener(now_ms));
    if (this.isSoftware) {
      this.#suitScale(isHeld, now_ms);
    }
    this.widget.resize();
    const before = this.#pictureNumber();
    const started_ms = this.#cost.start();
    this.widget.render();
    if (this.#pictureNumber() !== before) {
      this.#isAsked = false;
      this.#drawn_ms = now_ms;
      this.#drawn += 1;
      this.#cost.finish();
      this.labels.arrange();
      if (this.#copied === null) {
        this.labels.paint();
      }
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
      this.labels.paint();
      hastenTiles(this.scene, cost_ms);
    }
    // The cost of a fine picture at rest says nothing about the next moving one.
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

  /**
   * Coarse from the first movement on, fine again when nothing has moved for a while. Newly loaded images of the
   * ground do not count.
   */
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

  #pictureNumber(): number {
    // Not in the published types; nothing else tells whether a picture was drawn.
    return (this.scene as unknown as { frameState: { frameNumber: number } }).frameState.frameNumber;
  }

  /** The WebGL canvas is invisible, but still receives the pointer. */
  #seenBy(picture: HTMLCanvasElement): CopiedPicture {
    const copied = new CopiedPicture(picture, true);
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
