import { usePage } from "../../store/hooks";
import { ActiveAlarms } from "./ActiveAlarms";
import "./alarms.css";
import { PastAlarms } from "./PastAlarms";
import { SoundSettings } from "./SoundSettings";
import { Thresholds } from "./Thresholds";

/** "Alarmas": active and past alarms, their thresholds, sound and speech. Only the present is heard. */
export function AlarmsView() {
  const { past } = usePage();
  return (
    <div className="alarms">
      <div className="alarms-lists">
        <ActiveAlarms />
        <PastAlarms />
      </div>
      <div className="alarms-settings">
        {past === null && <SoundSettings />}
        <Thresholds />
      </div>
    </div>
  );
}
