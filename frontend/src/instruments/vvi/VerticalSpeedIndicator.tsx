import { PointerDial, type PointerDialProps } from "../dial/PointerDial";
import { VERTICAL_SPEED_GEOMETRY, type VerticalSpeedUnit } from "./geometry";

/**
 * Vertical speed, climb positive, painted in feet per minute as `vertical_speed_ft_min` whatever unit is on its face.
 */
export function VerticalSpeedIndicator({
  face = "ftPerMin",
  ...props
}: PointerDialProps & { face?: VerticalSpeedUnit }) {
  return (
    <PointerDial
      {...props}
      geometry={VERTICAL_SPEED_GEOMETRY[face]}
      attribute="data-vertical-speed-ft-min"
      decimals={0}
    />
  );
}
