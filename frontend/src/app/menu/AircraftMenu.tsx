import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { type Source, useSource } from "../../features/controls/sourceReturn";
import { GAMEPADS } from "../../features/gamepad/gamepadList";
import { TOUCH_STICK } from "../../features/gamepad/touchStick";
import { useGamepadBlocked } from "../../features/gamepad/useGamepadBlocked";
import { useStickIsMine, useStickKind } from "../../readouts/useStick";
import { ACTIONS } from "../../requests/actions";
import { useBoardBlocked, useGatewayBlocked } from "../../requests/useBlocked";
import { usePage, usePart, useTelemetry } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Menu, MenuAction, MenuGroup, MenuRule } from "../../ui/MenuBar";
import { useDialogs } from "../views/useDialogs";
import { CommandItem, useOutcome } from "./items";

/** Numbers of `servos_control_mode` on the wire. */
const FLY_BY_WIRE = 0;
const HIL = 1;

export function AircraftMenu() {
  const { t } = useTranslation();
  return (
    <Menu label={t("menu.aircraft")}>
      <MenuGroup label={t("toolbar.source")}>
        <SourceItem source="rc" label={t("menu.planeRc")} />
        <SourceItem source="joystick" label={t("menu.planeJoystick")} />
      </MenuGroup>
      <MenuRule />
      <MenuGroup label={t("gamepad.stick")}>
        <StickItems />
      </MenuGroup>
      <MenuRule />
      <MenuGroup label={t("menu.servosOut")}>
        <ServosMode />
      </MenuGroup>
    </Menu>
  );
}

function SourceItem({ source, label }: { source: Source; label: string }) {
  const actions = usePart(ACTIONS);
  const current = useSource();
  return (
    <MenuAction
      label={label}
      isCurrent={current === source}
      disabledReason={useBoardBlocked()}
      onChoose={() => void actions.setHil({ source }, { control: "source", asked: source })}
      {...useOutcome("source", source)}
    />
  );
}

/** Where the stick comes from while the source is the joystick. */
function StickItems() {
  const { t } = useTranslation();
  const { settings } = usePage();
  const gamepads = usePart(GAMEPADS);
  const kind = useStickKind();
  const isMine = useStickIsMine();
  const touch = usePart(TOUCH_STICK);
  const isOnScreen = useStore(touch.store, ({ isOpen }) => isOpen);
  const { close } = useDialogs();
  return (
    <>
      <MenuAction
        label={t("gamepad.simulator")}
        isCurrent={kind === "simulator"}
        disabledReason={useGatewayBlocked()}
        onChoose={() => void gamepads.flySimulator({ control: "stick", asked: "simulator" })}
        {...useOutcome("stick", "simulator")}
      />
      <MenuAction
        label={t("gamepad.browser")}
        isCurrent={isMine}
        disabledReason={useGamepadBlocked()}
        onChoose={() => void gamepads.fly({ control: "stick", asked: "gamepad" })}
        {...useOutcome("stick", "gamepad")}
      />
      <MenuAction
        label={t("touchStick.open")}
        isCurrent={isOnScreen}
        onChoose={() => {
          touch.store.setState({ isOpen: !isOnScreen });
          close();
        }}
      />
      <MenuAction label={t("gamepad.adjust")} onChoose={() => choose(settings, "tab", "setup")} />
    </>
  );
}

/** What drives the servo outputs; only a board with the extensions reports it. */
function ServosMode() {
  const { t } = useTranslation();
  const mode = useTelemetry((telemetry, now_ms) =>
    telemetry.liveNumber("board_status", "servos_control_mode", now_ms),
  );
  return (
    <>
      <CommandItem
        command="servos_control_mode_fly_by_wire"
        label={t("menu.flyByWire")}
        control="servosMode"
        asked="flyByWire"
        isCurrent={mode === FLY_BY_WIRE}
      />
      <CommandItem
        command="servos_control_mode_hil"
        label={t("menu.hil")}
        control="servosMode"
        asked="hil"
        isCurrent={mode === HIL}
      />
    </>
  );
}
