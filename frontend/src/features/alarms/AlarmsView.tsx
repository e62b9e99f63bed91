import { ActiveAlarms } from "./ActiveAlarms";
import "./alarms.css";
import { Heard } from "./Heard";
import { PastAlarms } from "./PastAlarms";
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
        <Heard />
        <Thresholds />
      </div>
    </div>
  );
}
