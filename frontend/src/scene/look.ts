/** How the drawn ground looks: by day, or dim for eyes that are used to the dark. */
export const LIGHTS = ["day", "night"] as const;
export type Light = (typeof LIGHTS)[number];

export interface GroundLook {
  readonly sea: string;
  readonly shallows: string;
  readonly land: string;
  readonly coast: string;
  readonly border: string;
  readonly asphalt: string;
  readonly grass: string;
  readonly water: string;
  readonly paint: string;
}

export const GROUND: Readonly<Record<Light, GroundLook>> = {
  day: {
    sea: "#2f6690",
    shallows: "rgb(150 210 220 / 18%)",
    land: "#8b8a63",
    coast: "#f2e9c9",
    border: "rgb(92 52 92 / 75%)",
    asphalt: "#33383c",
    grass: "#4f7a3d",
    water: "#4a8fc0",
    paint: "#f4f4f0",
  },
  night: {
    sea: "#0a1723",
    shallows: "rgb(90 140 160 / 10%)",
    land: "#232a26",
    coast: "#6d7a72",
    border: "rgb(150 110 150 / 60%)",
    asphalt: "#0c0f11",
    grass: "#1c3319",
    water: "#14324a",
    paint: "#c9cfc9",
  },
};
