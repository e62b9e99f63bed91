import "./playback.css";
import { Flag } from "lucide-react";
import { useCallback, useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { isTyping } from "../../lib/typing";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { MarkDialog } from "./MarkDialog";
import { PLAYBACK } from "./playbackRequests";
import { TimeControls } from "./TimeControls";
import { TimeTrack } from "./TimeTrack";
import { runInPast, type TimeAction, timeAction } from "./timeKeys";
import { useEdge_s, useIsRecording, usePlayback } from "./usePlayback";

/**
 * The time bar under all tabs. In the present it is thin: the flight so far, with now at its right edge. `hasKeys`:
 * whether single letters are shortcuts.
 */
export function TimeBar({ hasKeys }: { readonly hasKeys: boolean }) {
  const { t } = useTranslation();
  const playback = usePart(PLAYBACK);
  const isPast = usePlayback(({ flight }) => flight !== null);
  const isRecording = useIsRecording();
  const isKnown = useEdge_s() > 0;
  const [isMarking, setMarking] = useState(false);
  const mark = useCallback(() => setMarking(true), []);
  const isWatched = isPast || isRecording;
  useEffect(() => (isWatched ? playback.facts.watch() : undefined), [playback, isWatched]);
  useTimeKeys(isPast, isPast || isRecording ? mark : null, hasKeys);
  return (
    <section className="time" data-past={isPast} aria-label={t("time.label")}>
      {isPast && <TimeControls onMark={mark} />}
      {isPast || (isRecording && isKnown) ? (
        <TimeTrack onMark={mark} />
      ) : (
        <p className="time-none">{t(isRecording ? "time.reading" : "time.none")}</p>
      )}
      {!isPast && isRecording && (
        <>
          <span className="time-now">{t("time.live")}</span>
          <Button onPress={mark} label={t("time.markLong")} icon={<Flag size={14} aria-hidden="true" />}>
            {t("time.mark")}
          </Button>
        </>
      )}
      {isMarking && <MarkDialog onClose={() => setMarking(false)} />}
    </section>
  );
}

/** Keys that work wherever the focus is: Esc, M and the speed with Shift; the others where nothing else has it. */
function useTimeKeys(isPast: boolean, onMark: (() => void) | null, hasKeys: boolean): void {
  const playback = usePart(PLAYBACK);
  useEffect(() => {
    function press(event: KeyboardEvent): void {
      const action = event.defaultPrevented || isTyping(event.target) ? null : timeAction(event);
      const isDone = action !== null && (action.do === "mark" ? mark(event) : move(action, event));
      if (isDone) {
        event.preventDefault();
      }
    }
    function mark({ repeat }: KeyboardEvent): boolean {
      const canMark = onMark !== null && hasKeys && !repeat;
      if (canMark) {
        onMark();
      }
      return canMark;
    }
    function move(action: TimeAction, { target, shiftKey }: KeyboardEvent): boolean {
      // A list has the arrows for itself, and leaves them to the speed where Shift is held.
      const isOfList = !shiftKey || target instanceof HTMLInputElement;
      const isFree = action.do === "now" || (action.do === "rate" && !isOfList) || target === document.body;
      return isPast && isFree && runInPast(playback, action);
    }
    window.addEventListener("keydown", press);
    return () => window.removeEventListener("keydown", press);
  }, [playback, isPast, onMark, hasKeys]);
}
