import { FoldVertical } from "lucide-react";
import { memo, useId } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatFixed } from "../../lib/format";
import { COMMANDS } from "../../protocol/messages.gen";
import { CommandButton } from "../../requests/CommandButton";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePart, useTelemetry } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { VerticalSlider } from "../../ui/VerticalSlider";
import { SERVO_COUNT, SERVO_SLIDERS } from "./servoPositions";
import { useServo, useServoFailure } from "./useServo";
import "./servos-out.css";

const [, POSITION] = COMMANDS.servo_out.arguments;
const MINIMUM = POSITION?.minimum ?? -1;
const MAXIMUM = POSITION?.maximum ?? 1;
const CENTRE = 0;
/** Step of the slider and of the arrow keys. */
const STEP = 0.01;
const INDICES = Array.from({ length: SERVO_COUNT }, (_, index) => index);
const MODES = ["fly_by_wire", "hil"] as const;

/**
 * "ServosOut": a slider for each servo output. The board never reports their positions, so a slider only knows its
 * own moves.
 */
export function ServosOut() {
  const { t } = useTranslation();
  const servos = usePart(SERVO_SLIDERS);
  const blocked = useBoardBlocked();
  const reasonId = useId();
  return (
    <div className="servos-out">
      <div className="servos-out-head">
        <span id={reasonId}>{blocked ?? t("servosOut.hint")}</span>
        <ControlMode />
        <Button
          onPress={() => {
            for (const servo of INDICES) {
              servos.move(servo, CENTRE);
            }
          }}
          disabledReason={blocked}
        >
          {t("servosOut.centreAll")}
        </Button>
      </div>
      <div className="servos-out-row">
        {INDICES.map((index) => (
          <ServoSlider key={index} index={index} blocked={blocked} reasonId={reasonId} />
        ))}
      </div>
      <Failure />
    </div>
  );
}

interface SliderProps {
  index: number;
  blocked: string | undefined;
  reasonId: string;
}

const ServoSlider = memo(function ServoSlider({ index, blocked, reasonId }: SliderProps) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const servos = usePart(SERVO_SLIDERS);
  const { position, state, message } = useServo(index);
  const number = index + 1;
  return (
    <VerticalSlider
      label={String(number)}
      name={t("servosOut.servo", { number })}
      value={position}
      minimum={MINIMUM}
      maximum={MAXIMUM}
      step={STEP}
      rest={CENTRE}
      format={(value) => formatFixed(value, 2) ?? ""}
      noValueText={t("servosOut.notMoved")}
      onMove={(value) => servos.move(index, value)}
      state={state}
      stateText={message === null ? undefined : sentence(message)}
      disabledReason={blocked}
      describedBy={reasonId}
    >
      <Button
        onPress={() => servos.move(index, CENTRE)}
        label={t("servosOut.centre", { number })}
        disabledReason={blocked}
        icon={<FoldVertical aria-hidden="true" size={14} />}
      >
        {null}
      </Button>
    </VerticalSlider>
  );
});

/**
 * What drives the servos that no slider has taken, as the board reports it; choosing a mode releases the first four
 * from the sliders.
 */
function ControlMode() {
  const { t } = useTranslation();
  const mode = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber("board_status", "servos_control_mode", now_ms),
  );
  const name = MODES[mode ?? -1];
  return (
    <div className="servos-out-mode">
      <span>
        {t("servosOut.mode", { mode: name === undefined ? t("words.unknown") : t(`servosOut.${name}`) })}
      </span>
      <CommandButton command="servos_control_mode_fly_by_wire">{t("servosOut.fly_by_wire")}</CommandButton>
      <CommandButton command="servos_control_mode_hil">{t("servosOut.hil")}</CommandButton>
    </div>
  );
}

/** The reason of a refusal, while a slider shows it. */
function Failure() {
  const sentence = useSentence();
  const message = useServoFailure();
  return message === null ? null : <Notice level="error">{sentence(message)}</Notice>;
}
