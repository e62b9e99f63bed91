import type { Position } from "../../lib/geodesy";
import type { FieldSource } from "../../protocol/guards.gen";
import type { FieldOrder } from "./field";

export const KINDS = ["heights", "imagery", "vector"] as const;
export type Kind = (typeof KINDS)[number];
export const NONE = "none";
export const OWN = "own";

/** What a person has chosen for one kind. `source`: the id of a public one, OWN or NONE. */
export interface PartDraft {
  readonly source: string;
  readonly url: string;
  readonly attribution: string;
  readonly zoom: number;
}

export interface Draft {
  readonly name: string;
  readonly where: "circle" | "flight" | "hil";
  /** Null: nobody has said where. */
  readonly centre: Position | null;
  readonly radius_km: number;
  readonly parts: Readonly<Record<Kind, PartDraft>>;
}

const LOWEST_ZOOM = 8;
export const HIGHEST_ZOOM: Readonly<Record<Kind, number>> = { heights: 14, imagery: 19, vector: 15 };
const NOTHING: PartDraft = { source: NONE, url: "", attribution: "", zoom: 12 };
/** Buildings and small roads are in the tiles of this level, which is also the last that most servers have. */
const VECTOR_ZOOM = 14;

/** Nothing is chosen: no source is asked that nobody picked. */
export function newDraft(centre: Position | null, name: string): Draft {
  return {
    name,
    where: "circle",
    centre,
    radius_km: 10,
    parts: { heights: NOTHING, imagery: NOTHING, vector: { ...NOTHING, zoom: VECTOR_ZOOM } },
  };
}

/** Sources of the whole world that together are enough to fly by. */
const READY: Partial<Readonly<Record<Kind, string>>> = { heights: "terrain-tiles", imagery: "sentinel2" };

/** The draft with the set that is ready for any place; null if something is chosen, or the station offers none of it. */
export function readyDraft(draft: Draft, sources: readonly FieldSource[]): Draft | null {
  const found = sources.filter(({ id, kind }) => READY[kind] === id);
  if (found.length === 0 || KINDS.some((kind) => draft.parts[kind].source !== NONE)) {
    return null;
  }
  const parts = { ...draft.parts };
  for (const { id, kind, usual_zoom } of found) {
    parts[kind] = { ...parts[kind], source: id, zoom: usual_zoom };
  }
  return { ...draft, name: draft.name.trim() === "" ? placeName(draft) : draft.name, parts };
}

function placeName({ where, centre }: Draft): string {
  return where !== "circle" || centre === null
    ? "plan"
    : `${centre.latitude_deg.toFixed(3)}, ${centre.longitude_deg.toFixed(3)}`;
}

/** The order, as soon as it is one: a name, a place, and a source for at least one kind. */
export function orderOf(
  draft: Draft,
  plan: readonly Position[],
  sources: readonly FieldSource[],
): FieldOrder | null {
  const points = draft.where !== "circle" ? plan : draft.centre === null ? [] : [draft.centre];
  const parts = KINDS.flatMap((kind) => partOf(kind, draft.parts[kind], sources));
  if (draft.name.trim() === "" || points.length === 0 || parts.length === 0) {
    return null;
  }
  return {
    name: draft.name.trim(),
    points: points.map(({ latitude_deg, longitude_deg }) => ({ latitude_deg, longitude_deg })),
    radius_m: draft.radius_km * 1000,
    parts,
  };
}

/** How far a source's levels go. */
export function highestZoom(kind: Kind, source: FieldSource | undefined): number {
  return source?.maximum_zoom ?? HIGHEST_ZOOM[kind];
}

/** Whether a source's pieces are whole square degrees, which have no levels. */
export function hasLevels(url: string): boolean {
  return !url.includes("{latitude}");
}

function partOf(
  kind: Kind,
  draft: PartDraft,
  sources: readonly FieldSource[],
): FieldOrder["parts"][number][] {
  const source = sources.find(({ id }) => id === draft.source);
  const url = source?.url ?? draft.url.trim();
  if (draft.source === NONE || url === "") {
    return [];
  }
  return [
    {
      kind,
      name: source?.name ?? hostOf(url),
      url,
      attribution: source?.attribution ?? draft.attribution,
      minimum_zoom: Math.min(LOWEST_ZOOM, draft.zoom),
      maximum_zoom: draft.zoom,
    },
  ];
}

function hostOf(url: string): string {
  return /^[a-z]+:\/\/([^/]{1,70})/i.exec(url)?.[1] ?? url.slice(0, 70);
}
