import { PointerDial, type PointerDialProps } from "../dial/PointerDial";
import { VERTICAL_SPEED_GEOMETRY } from "./geometry";

/** Vertical speed in feet per minute, climb positive, painted as `vertical_speed_ft_min`. */
export function VerticalSpeedIndicator(props: PointerDialProps) {
  return (
    <PointerDial
      {...props}
      geometry={VERTICAL_SPEED_GEOMETRY}
      attribute="data-vertical-speed-ft-min"
      decimals={0}
    />
  );
}
