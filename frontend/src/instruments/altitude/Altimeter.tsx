import { PointerDial, type PointerDialProps } from "../dial/PointerDial";
import { ALTITUDE_GEOMETRY } from "./geometry";

/** Altitude above mean sea level in feet, painted as `altitude_ft`; barometer or GPS, the caption says. */
export function Altimeter(props: PointerDialProps) {
  return <PointerDial {...props} geometry={ALTITUDE_GEOMETRY} attribute="data-altitude-ft" decimals={0} />;
}
