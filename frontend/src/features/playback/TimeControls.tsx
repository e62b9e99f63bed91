import {
  ChevronFirst,
  ChevronLast,
  Flag,
  Link2,
  Pause,
  Play,
  Repeat,
  StepBack,
  StepForward,
} from "lucide-react";
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatFlightTime } from "../../lib/moment";
import { usePage, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { copyText } from "../../ui/copyText";
import { Select } from "../../ui/Select";
import { SteadyText, type SteadyTextHandle } from "../../ui/SteadyText";
import { PLAYBACK } from "./playbackRequests";
import { RATES } from "./playbackState";
import { usePlayback } from "./usePlayback";

const ICON = { size: 16, "aria-hidden": true } as const;

/** What can be done with the flight that is looked at. */
export function TimeControls({ onMark }: { readonly onMark: () => void }) {
  const { t } = useTranslation();
  const playback = usePart(PLAYBACK);
  const isPlaying = usePlayback(({ state }) => state === "playing");
  return (
    <div className="time-controls" role="toolbar" aria-label={t("time.controls")}>
      <Button
        onPress={() => playback.jump(-1)}
        label={t("time.eventBefore")}
        icon={<ChevronFirst {...ICON} />}
      >
        {""}
      </Button>
      <Button onPress={() => playback.step(-1)} label={t("time.frameBack")} icon={<StepBack {...ICON} />}>
        {""}
      </Button>
      <Button
        onPress={isPlaying ? playback.pause : playback.play}
        label={t(isPlaying ? "time.pause" : "time.play")}
        icon={isPlaying ? <Pause {...ICON} /> : <Play {...ICON} />}
      >
        {""}
      </Button>
      <Button onPress={() => playback.step(1)} label={t("time.frameOn")} icon={<StepForward {...ICON} />}>
        {""}
      </Button>
      <Button onPress={() => playback.jump(1)} label={t("time.eventAfter")} icon={<ChevronLast {...ICON} />}>
        {""}
      </Button>
      <Rate />
      <Loop />
      <FlightTime />
      <Button onPress={onMark} label={t("time.markLong")} icon={<Flag {...ICON} />}>
        {t("time.mark")}
      </Button>
      <Copy />
    </div>
  );
}

function Rate() {
  const { t } = useTranslation();
  const playback = usePart(PLAYBACK);
  const rate = usePlayback((state) => state.rate);
  const offered = RATES.includes(rate) ? RATES : [...RATES, rate].sort((one, other) => one - other);
  return (
    <Select
      label={t("time.rate")}
      hideLabel
      options={offered.map((value) => ({
        value: String(value),
        label: t("time.rateValue", { rate: value }),
      }))}
      value={String(rate)}
      onChange={(value) => playback.setRate(Number(value))}
      placeholder={t("time.rate")}
    />
  );
}

/** First press: the stretch begins here. Second: it ends here and is played again and again. Third: no more. */
function Loop() {
  const { t } = useTranslation();
  const playback = usePart(PLAYBACK);
  const loop = usePlayback((state) => state.loop);
  const [from_s, setFrom] = useState<number | null>(null);
  function press(): void {
    const { at_s } = playback.store.getState();
    if (loop !== null) {
      playback.loop(null);
    } else if (from_s === null) {
      setFrom(at_s);
    } else {
      setFrom(null);
      if (at_s !== from_s) {
        playback.loop([Math.min(from_s, at_s), Math.max(from_s, at_s)]);
      }
    }
  }
  const words =
    loop !== null
      ? t("time.loopOff", { from: formatFlightTime(loop[0]), to: formatFlightTime(loop[1]) })
      : from_s === null
        ? t("time.loopFrom")
        : t("time.loopTo", { from: formatFlightTime(from_s) });
  return (
    <Button
      onPress={press}
      pressed={loop !== null || from_s !== null}
      label={words}
      icon={<Repeat {...ICON} />}
    >
      {loop === null && from_s === null ? "" : words}
    </Button>
  );
}

/** Time of the flight and how long it is, written without a render. */
function FlightTime() {
  const { store } = usePart(PLAYBACK);
  const text = useRef<SteadyTextHandle>(null);
  useEffect(() => {
    const write = (): void => {
      const { at_s, duration_s, edge_s } = store.getState();
      text.current?.write(`${formatFlightTime(at_s, 1)} / ${formatFlightTime(Math.max(edge_s, duration_s))}`);
    };
    write();
    return store.subscribe(write);
  }, [store]);
  return <SteadyText ref={text} chars={17} className="time-clock" />;
}

function Copy() {
  const { t } = useTranslation();
  const { messages } = usePage();
  const playback = usePart(PLAYBACK);
  return (
    <Button
      label={t("time.copyLong")}
      icon={<Link2 {...ICON} />}
      onPress={() => {
        void copyText(playback.address()).then((isCopied) =>
          messages.say(
            isCopied
              ? { level: "info", key: "time.copied", params: {} }
              : { level: "error", key: "time.notCopied", params: {} },
          ),
        );
      }}
    >
      {t("time.copy")}
    </Button>
  );
}
