import { wrap360 } from "../../lib/units";
import { polar, round, series, tickPath } from "../dial/scale";

/** The letters of the four cardinal points; the language is the caller's. */
export interface Cardinals {
  readonly north: string;
  readonly east: string;
  readonly south: string;
  readonly west: string;
}

/** Radius of the compass card's edge. */
export const CARD_RADIUS = 82;

/** Turn of the card: a heading of 90 brings the east mark, drawn at three o'clock, up to the lubber line. */
export function cardTurn_deg(heading_deg: number): number {
  return turn(-heading_deg);
}

/** Turn of the bug, which rides on the card at the bearing that the flight plan asks for. */
export function bugTurn_deg(heading_deg: number, bearing_deg: number): number {
  return turn(bearing_deg - heading_deg);
}

/** Heading or bearing as it is written: one decimal, 359.96 is 0.0 and never 360.0. */
export function attributeBearing(bearing_deg: number): string {
  return wrap360(Math.round(wrap360(bearing_deg) * 10) / 10).toFixed(1);
}

export interface CardNumeral {
  readonly text: string;
  readonly angle_deg: number;
  readonly cardinal: boolean;
}

/** What stands on the card each 30 degrees: the cardinal's letter, else tens of degrees. */
export function cardNumerals(cardinals: Cardinals): CardNumeral[] {
  const letters = new Map([
    [0, cardinals.north],
    [90, cardinals.east],
    [180, cardinals.south],
    [270, cardinals.west],
  ]);
  return series(0, 330, 30).map((angle_deg) => {
    const letter = letters.get(angle_deg);
    return { angle_deg, cardinal: letter !== undefined, text: letter ?? String(angle_deg / 10) };
  });
}

const ALL = series(0, 355, 5);

export const TICKS_FIVE = tickPath(
  ALL.filter((angle_deg) => angle_deg % 10 !== 0),
  CARD_RADIUS - 5,
  CARD_RADIUS,
);

export const TICKS_TEN = tickPath(
  ALL.filter((angle_deg) => angle_deg % 10 === 0),
  CARD_RADIUS - 9,
  CARD_RADIUS,
);

/** Fixed marks outside the card each 45 degrees, to read a turn by. */
export const REFERENCE_MARKS = [45, 90, 135, 180, 225, 270, 315].map((angle_deg) => ({
  angle_deg,
  ...polar(89, angle_deg),
}));

function turn(angle_deg: number): number {
  return wrap360(round(wrap360(angle_deg)));
}
