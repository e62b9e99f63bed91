import { PointerDial, type PointerDialProps } from "../dial/PointerDial";
import { ALTITUDE_GEOMETRY, type AltitudeUnit } from "./geometry";

/**
 * Altitude above mean sea level, painted in feet as `altitude_ft` whatever its face is engraved in; barometer or GPS,
 * the caption says.
 */
export function Altimeter({ face = "ft", ...props }: PointerDialProps & { face?: AltitudeUnit }) {
  return (
    <PointerDial {...props} geometry={ALTITUDE_GEOMETRY[face]} attribute="data-altitude-ft" decimals={0} />
  );
}
