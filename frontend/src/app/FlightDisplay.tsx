import { ModeAnnunciator } from "../features/controls/ModeAnnunciator";
import { PrimaryDisplay } from "../features/fly/PrimaryDisplay";
import { MAP_TOOL } from "../features/map/tools/mapTool";
import { useShowSignal } from "../features/plots/usePlots";
import { useFlownAircraft } from "../readouts/flownAircraft";
import { usePage, usePart } from "../store/hooks";
import { choose } from "../store/settings";
import { useDialogs } from "./views/useDialogs";

/** The display of the flight view, with what its parts open: the control path, plots, and the plan's targets. */
export function FlightDisplay() {
  const { settings } = usePage();
  const { open } = useDialogs();
  const tools = usePart(MAP_TOOL);
  const showSignal = useShowSignal();
  const aircraft = useFlownAircraft();
  return (
    <PrimaryDisplay
      modes={<ModeAnnunciator aircraft={aircraft} onPress={() => open("signal")} />}
      onPlot={(signal) => {
        showSignal(signal);
        choose(settings, "tab", "plots");
      }}
      onTarget={(target) => tools.setState({ target })}
    />
  );
}
