import type { Aircraft } from "../../lib/aircraft";
import type { NumberField, TopicName } from "../../protocol/topics";
import type { ReadoutRow } from "../../readouts/LiveReadout";
import { ANGLE, COUNT, HEADING, LOAD, VOLTAGE } from "../../readouts/notations";

type TopicFigure = { [T in TopicName]: ReadoutRow<NumberField<T>> & { readonly topic: T } }[TopicName];

/** A number that a person may put on the flight view: of a topic, or made of several. */
export type Figure = TopicFigure | { readonly made: "height" | "wind" };

/** By the name that is stored. */
const FIGURES = {
  airspeed: { topic: "analog", field: "calibrated_airspeed_kt", label: "flying.airspeed", as: "speed" },
  groundSpeed: { topic: "gps", field: "speed_kt", label: "flying.groundSpeed", as: "speed" },
  altitude: { topic: "analog", field: "altitude_m", label: "fly.figure.baro", as: "altitude" },
  gpsAltitude: { topic: "gps", field: "altitude_m", label: "fly.figure.gpsAltitude", as: "altitude" },
  height: { made: "height" },
  climb: { topic: "analog", field: "vvi_ft_min", label: "fly.figure.climb", as: "verticalSpeed" },
  heading: { topic: "ahrs", field: "yaw_deg", label: "attitude.heading", as: HEADING },
  course: { topic: "gps", field: "heading_deg", label: "fly.figure.course", as: HEADING },
  wind: { made: "wind" },
  pitch: { topic: "ahrs", field: "pitch_deg", label: "attitude.pitch", as: ANGLE },
  roll: { topic: "ahrs", field: "roll_deg", label: "attitude.roll", as: ANGLE },
  battery: { topic: "analog", field: "battery_v", label: "map.figures.battery", as: VOLTAGE },
  satellites: { topic: "gps", field: "satellites", label: "fly.figure.satellites", as: COUNT },
  distance: { topic: "fms_plan", field: "distance_m", label: "map.figures.toWaypoint", as: "distance" },
  bearing: { topic: "fms_plan", field: "bearing_deg", label: "fly.figure.bearing", as: HEADING },
  simAirspeed: {
    topic: "simulator",
    field: "indicated_airspeed_kt",
    label: "flying.airspeed",
    as: "speed",
  },
  simAltitude: {
    topic: "simulator",
    field: "altitude_msl_ft",
    label: "analog.altitude",
    as: "altitude",
  },
  simClimb: { topic: "simulator", field: "vvi_ft_min", label: "fly.figure.climb", as: "verticalSpeed" },
  simG: { topic: "simulator", field: "g_normal", label: "hil.gNormal", as: LOAD },
  hilDistance: {
    topic: "fms_hil_plan",
    field: "distance_m",
    label: "map.figures.toWaypoint",
    as: "distance",
  },
  hilBearing: { topic: "fms_hil_plan", field: "bearing_deg", label: "fly.figure.bearing", as: HEADING },
} as const satisfies Readonly<Record<string, Figure>>;

export type FigureName = keyof typeof FIGURES;
export const FIGURE_NAMES = Object.keys(FIGURES) as readonly FigureName[];

/** Before anybody chose: what one asks for first in flight, of each aircraft what it sends. */
const USUAL: Readonly<Record<Aircraft, readonly FigureName[]>> = {
  flight: ["groundSpeed", "climb", "height", "distance", "battery", "wind"],
  hil: ["groundSpeed", "simClimb", "height", "hilDistance", "battery", "wind"],
};

export const FIGURES_CHOICE = "fly.figures";

export function figureOf(name: FigureName): Figure {
  return FIGURES[name];
}

/** The six figures that were chosen; the usual ones in the places of unknown names. */
export function chosenFigures(choice: string | undefined, aircraft: Aircraft): readonly FigureName[] {
  const names = (choice ?? "").split(" ");
  return USUAL[aircraft].map((usual, place) => FIGURE_NAMES.find((name) => name === names[place]) ?? usual);
}
