import { ActiveAlarms } from "./ActiveAlarms";
import "./alarms.css";
import { PastAlarms } from "./PastAlarms";
import { SoundSettings } from "./SoundSettings";
import { Thresholds } from "./Thresholds";

/** "Alarmas": active and past alarms, their thresholds, sound and speech. */
export function AlarmsView() {
  return (
    <div className="alarms">
      <div className="alarms-lists">
        <ActiveAlarms />
        <PastAlarms />
      </div>
      <div className="alarms-settings">
        <SoundSettings />
        <Thresholds />
      </div>
    </div>
  );
}
