import { PointerDial, type PointerDialProps } from "../dial/PointerDial";
import { AIRSPEED_GEOMETRY } from "./geometry";

/** Airspeed in knots, painted as `airspeed_kt`; which airspeed it is, the caption says. */
export function AirspeedIndicator(props: PointerDialProps) {
  return <PointerDial {...props} geometry={AIRSPEED_GEOMETRY} attribute="data-airspeed-kt" decimals={1} />;
}
