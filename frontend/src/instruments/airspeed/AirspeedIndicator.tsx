import { PointerDial, type PointerDialProps } from "../dial/PointerDial";
import { AIRSPEED_GEOMETRY, type AirspeedUnit } from "./geometry";

/** Airspeed, painted in knots as `airspeed_kt` whatever unit is on its face; the caption says which airspeed. */
export function AirspeedIndicator({ face = "kt", ...props }: PointerDialProps & { face?: AirspeedUnit }) {
  return (
    <PointerDial {...props} geometry={AIRSPEED_GEOMETRY[face]} attribute="data-airspeed-kt" decimals={1} />
  );
}
