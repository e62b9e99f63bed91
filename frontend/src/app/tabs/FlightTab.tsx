import { FlightView } from "../../features/flight/FlightView";
import { ServosOut } from "../../features/servos/ServosOut";

/** "Datos de vuelo", with the sliders of the servo outputs in their place. */
export function FlightTab() {
  return <FlightView servosOut={<ServosOut />} />;
}
