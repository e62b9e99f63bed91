import { Crosshair, Gamepad2, Joystick, RotateCcw } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { useStickIsMine, useStickKind } from "../../readouts/useStick";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useCommandEntry, useConnection, usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { SegmentedSwitch } from "../../ui/SegmentedSwitch";
import { Select } from "../../ui/Select";
import { GAMEPADS, useGamepads } from "./gamepadList";
import { StickAxisRow } from "./StickAxisRow";
import { STICK_AXES } from "./stickMapping";
import { useAwaitedAxes, useGamepadBlocked } from "./useGamepadBlocked";
import "./stick.css";

/** The pilot's stick: where it comes from, and which axis of this browser's gamepad moves what. */
export function StickPanel() {
  const { t } = useTranslation();
  return (
    <Panel title={t("gamepad.stick")} className="setup-stick">
      <div className="setup-stick-head">
        <StickSwitch />
        <PadChoice />
      </div>
      <StickNotice />
      <AwaitedAxes />
      <PadAxes />
    </Panel>
  );
}

function StickSwitch() {
  const { t } = useTranslation();
  const gamepads = usePart(GAMEPADS);
  const { state, stateText, wanted } = useAsked("stick");
  const kind = useStickKind();
  const blocked = useGatewayBlocked();
  const padBlocked = useGamepadBlocked();
  const isSimulator = kind === null || kind === "simulator";
  return (
    <SegmentedSwitch
      label={t("gamepad.from")}
      options={[
        {
          value: "simulator",
          label: t("gamepad.simulator"),
          icon: <Joystick aria-hidden="true" size={14} />,
        },
        { value: "gamepad", label: t("gamepad.browser"), icon: <Gamepad2 aria-hidden="true" size={14} /> },
      ]}
      value={kind === "lost" ? "gamepad" : kind}
      wanted={wanted === "simulator" || wanted === "gamepad" ? wanted : null}
      onChange={(asked) => {
        const asker = { control: "stick", asked };
        void (asked === "gamepad" ? gamepads.fly(asker) : gamepads.flySimulator(asker));
      }}
      state={state}
      stateText={stateText}
      disabledReason={blocked ?? (isSimulator ? padBlocked : undefined)}
    />
  );
}

function PadChoice() {
  const { t } = useTranslation();
  const gamepads = usePart(GAMEPADS);
  const pads = useGamepads((state) => state.pads);
  const selected = useGamepads((state) => (state.mapping === null ? null : state.selected));
  const isMine = useStickIsMine();
  return (
    <Select
      label={t("gamepad.pad")}
      options={pads.map(({ id, index }) => ({ value: `${index}`, label: `${index + 1}: ${id}` }))}
      value={selected === null ? null : `${selected.index}`}
      placeholder={t("gamepad.noPad")}
      disabledReason={
        pads.length === 0 ? t("gamepad.none") : isMine && selected !== null ? t("gamepad.flying") : undefined
      }
      onChange={(index) => {
        const pad = pads.find((one) => `${one.index}` === index);
        if (pad !== undefined) gamepads.select(pad);
      }}
    />
  );
}

/** The gamepad's state in one sentence. */
function StickNotice() {
  const { t } = useTranslation();
  const sentence = useSentence();
  const kind = useStickKind();
  const isMine = useStickIsMine();
  const gamepad = useConnection(({ status }) => status?.hil.stick?.gamepad ?? "");
  const name = useConnection(({ status }) => status?.hil.stick?.name ?? "");
  const blocked = useGamepadBlocked();
  const isAwaiting = useAwaitedAxes() !== undefined;
  const refusal = useCommandEntry("stick")?.message ?? null;
  if (refusal?.level === "error") {
    return <Notice level="error">{sentence(refusal)}</Notice>;
  }
  if (kind === "lost") {
    return <Notice level="error">{t("alarm.stick_lost", { gamepad })}</Notice>;
  }
  if (kind === "gamepad") {
    return (
      <Notice level="info">
        {isMine ? t("stickSaid.taken", { gamepad }) : t("stickSaid.other", { gamepad, name })}
      </Notice>
    );
  }
  return isAwaiting ? null : <Notice level="info">{blocked ?? t("gamepad.ready")}</Notice>;
}

/** Which axes must move before the gamepad is the stick, and the way to say that they stand as shown. */
function AwaitedAxes() {
  const { t } = useTranslation();
  const gamepads = usePart(GAMEPADS);
  const awaited = useAwaitedAxes();
  return awaited === undefined ? null : (
    <Notice level="warning">
      <p>{awaited}</p>
      <Button onPress={gamepads.agree}>{t("gamepad.agree")}</Button>
    </Notice>
  );
}

function PadAxes() {
  const { t } = useTranslation();
  const gamepads = usePart(GAMEPADS);
  const hasPad = useGamepads(({ mapping }) => mapping !== null);
  if (!hasPad) {
    return null;
  }
  return (
    <>
      <div className="setup-stick-axes">
        {STICK_AXES.map((axis) => (
          <StickAxisRow key={axis} axis={axis} />
        ))}
      </div>
      <div className="setup-buttons">
        <Button onPress={gamepads.centre} icon={<Crosshair aria-hidden="true" size={14} />}>
          {t("gamepad.centre")}
        </Button>
        <Button onPress={gamepads.reset} icon={<RotateCcw aria-hidden="true" size={14} />}>
          {t("gamepad.reset")}
        </Button>
      </div>
      <p className="setup-stick-hint">{t("gamepad.kept")}</p>
    </>
  );
}
