/** An image layer in the user's order, and how it is shown. */
export interface StackLayer {
  readonly id: string;
  readonly isOn: boolean;
  /** 0: transparent, 1: opaque. */
  readonly opacity: number;
}

/** The default place of a layer in the stack: files are shown, online sources are not. */
export interface Stackable {
  readonly id: string;
  readonly isOnByItself: boolean;
}

/** The layers from the topmost down, in the stored order; new ones are added on top. */
export function stackOf(layers: readonly Stackable[], remembered: string | undefined): readonly StackLayer[] {
  const known = parse(remembered);
  const there = new Set(layers.map(({ id }) => id));
  const isKnown = new Set(known.map(({ id }) => id));
  const added = layers
    .filter(({ id }) => !isKnown.has(id))
    .map(({ id, isOnByItself }) => ({ id, isOn: isOnByItself, opacity: 1 }));
  return [...added, ...known.filter(({ id }) => there.has(id))];
}

/** The order as stored text. A layer that is missing now keeps its place for its return. */
export function rememberedStack(stack: readonly StackLayer[], before: string | undefined): string {
  const present = new Set(stack.map(({ id }) => id));
  const away = parse(before).filter(({ id }) => !present.has(id));
  return JSON.stringify([...stack, ...away].map(({ id, isOn, opacity }) => [id, isOn, opacity]));
}

/** The stack with one layer changed; unchanged if the layer is not in it. */
export function withLayer(
  stack: readonly StackLayer[],
  id: string,
  change: Partial<Omit<StackLayer, "id">>,
): readonly StackLayer[] {
  return stack.map((one) => (one.id === id ? { ...one, ...change } : one));
}

/** The stack with one layer a place further up (-1) or down (1); unchanged at the end. */
export function movedLayer(stack: readonly StackLayer[], id: string, by: -1 | 1): readonly StackLayer[] {
  const at = stack.findIndex((one) => one.id === id);
  const [one, other] = [stack[at], stack[at + by]];
  return one === undefined || other === undefined ? stack : stack.with(at, other).with(at + by, one);
}

function parse(text: string | undefined): readonly StackLayer[] {
  let value: unknown;
  try {
    value = JSON.parse(text ?? "[]");
  } catch {
    return [];
  }
  return Array.isArray(value) ? value.flatMap((entry) => read(entry)) : [];
}

function read(entry: unknown): readonly StackLayer[] {
  if (!Array.isArray(entry)) {
    return [];
  }
  const [id, isOn, opacity]: unknown[] = entry;
  const isStacked =
    typeof id === "string" &&
    typeof isOn === "boolean" &&
    typeof opacity === "number" &&
    opacity >= 0 &&
    opacity <= 1;
  return isStacked ? [{ id, isOn, opacity }] : [];
}

export type AddressFault = "scheme" | "places" | "unreadable";

/** What is wrong with an online source's address: it needs the three tile numbers and https. */
export function addressFault(url: string): AddressFault | null {
  if (!/^https:\/\//i.test(url)) {
    return "scheme";
  }
  if (!["{z}", "{x}", "{y}"].every((place) => url.split(place).length === 2)) {
    return "places";
  }
  return URL.canParse(url.replace(/\{[zxy]\}/g, "0")) ? null : "unreadable";
}

const LONGEST_ID = 32;

/** A source's id made from its name, in the letters that the gateway allows; empty if none is left. */
export function sourceId(name: string): string {
  return name
    .normalize("NFD")
    .replace(/[\u0300-\u036f]/g, "")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .slice(0, LONGEST_ID)
    .replace(/^-+|-+$/g, "");
}
