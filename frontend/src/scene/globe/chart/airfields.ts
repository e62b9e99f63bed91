/** One end of a runway: where its number is painted. */
interface RunwayEnd {
  readonly name: string;
  readonly latitude_deg: number;
  readonly longitude_deg: number;
}

export interface Runway {
  readonly ends: readonly [RunwayEnd, RunwayEnd];
  readonly width_m: number;
}

export interface Airfield {
  readonly code: string;
  readonly latitude_deg: number;
  readonly longitude_deg: number;
  readonly elevation_ft: number;
  readonly runways: readonly Runway[];
}

/**
 * The airfield where the station's routes begin and end. Reference point from the Spanish AIP; runway ends from
 * OurAirports (public domain).
 */
export const GRAN_CANARIA: Airfield = {
  code: "GCLP",
  latitude_deg: 27.93194,
  longitude_deg: -15.38667,
  elevation_ft: 78,
  runways: [
    {
      ends: [
        { name: "03L", latitude_deg: 27.9189, longitude_deg: -15.3923 },
        { name: "21R", latitude_deg: 27.9449, longitude_deg: -15.3808 },
      ],
      width_m: 45,
    },
    {
      ends: [
        { name: "03R", latitude_deg: 27.9182, longitude_deg: -15.3904 },
        { name: "21L", latitude_deg: 27.9442, longitude_deg: -15.3788 },
      ],
      width_m: 45,
    },
  ],
};
