import { distance_m, type Position } from "../../lib/geodesy";
import { Repeating } from "../../lib/repeating";
import { BROWSER_TIMERS } from "../../lib/timers";
import type { NamedThing, NamedZone } from "../world/things";
import type { World } from "../world/World";

/** What is seen of the ground: names are asked for again when it has changed by enough. */
export interface Sight {
  readonly centre: Position;
  /** How far the middle of the picture is. */
  readonly sight_m: number;
  readonly zones: readonly NamedZone[];
}

/** Names are asked for again when the middle has moved by this share of the distance, or that has changed so much. */
const MOVED = 0.12;
const NEARER = 1.15;
const MOST = 500;
/** Between two questions, and after one that failed. */
const REST_MS = 250;
const FAILED_MS = 5000;

/** The things with names around what is seen, asked of the map's worker when the view has changed. */
export class NamedThings {
  readonly #world: World;
  readonly #onNews: () => void;
  #asked: Sight | null = null;
  #isWaiting = false;
  #next_ms = Number.NEGATIVE_INFINITY;
  #wanted: Sight | null = null;
  readonly #asks = new Repeating(BROWSER_TIMERS, () => this.#ask(), FAILED_MS);
  #things: readonly NamedThing[] = [];

  constructor(world: World, onNews: () => void) {
    this.#world = world;
    this.#onNews = onNews;
  }

  get things(): readonly NamedThing[] {
    return this.#things;
  }

  /** This is what is seen now. */
  see(sight: Sight): void {
    this.#wanted = sight;
    this.#asks.run();
  }

  dispose(): void {
    this.#asks.cancel();
    this.#wanted = null;
  }

  /** In how many milliseconds it may be asked again; null: nothing waits to be asked. */
  #ask(): number | null {
    const sight = this.#wanted;
    if (sight === null || this.#isWaiting || !isOther(sight, this.#asked)) {
      return null;
    }
    const rest_ms = this.#next_ms - performance.now();
    if (rest_ms > 0) {
      return rest_ms;
    }
    this.#asked = sight;
    this.#isWaiting = true;
    this.#world.ask<"things">({ kind: "things", ...sight, most: MOST }).then(
      (things) => {
        this.#things = things;
        this.#rest(REST_MS);
        this.#onNews();
      },
      () => {
        this.#asked = null;
        this.#rest(FAILED_MS);
      },
    );
    return null;
  }

  #rest(rest_ms: number): void {
    this.#isWaiting = false;
    this.#next_ms = performance.now() + rest_ms;
    this.#asks.run();
  }
}

function isOther(sight: Sight, before: Sight | null): boolean {
  if (before === null) {
    return true;
  }
  const change = sight.sight_m / before.sight_m;
  return (
    change > NEARER ||
    change < 1 / NEARER ||
    distance_m(sight.centre, before.centre) > MOVED * Math.min(sight.sight_m, before.sight_m)
  );
}
