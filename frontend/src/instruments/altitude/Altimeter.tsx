import { PointerDial, type PointerDialProps } from "../dial/PointerDial";
import { ALTITUDE_GEOMETRY, type AltitudeUnit } from "./geometry";

/**
 * Altitude above mean sea level, painted in feet as `altitude_ft` whatever unit is on its face; the caption says
 * barometer or GPS.
 */
export function Altimeter({ face = "ft", ...props }: PointerDialProps & { face?: AltitudeUnit }) {
  return (
    <PointerDial {...props} geometry={ALTITUDE_GEOMETRY[face]} attribute="data-altitude-ft" decimals={0} />
  );
}
