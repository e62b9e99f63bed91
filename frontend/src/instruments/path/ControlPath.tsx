import { LOWER_Y, PATH_SWITCH, SOURCE_SWITCH, type Switches, signalWay, UPPER_Y } from "./geometry";
import { Box, SwitchSymbol, Wire } from "./parts";
import "./path.css";

export interface ControlPathLabels {
  joystick: string;
  rc: string;
  manual: string;
  assisted: string;
  computer: string;
  autopilot: string;
  surfaces: string;
  /** Shown between stick and transmitter in automatic flight. */
  ignored: string;
  /** Shown over a switch whose position is unknown. */
  unknown: string;
}

interface Props extends Switches {
  /** Accessible name. */
  label: string;
  /** The same picture in one sentence, for screen readers. */
  description: string;
  labels: ControlPathLabels;
}

const BOX_HEIGHT = 28;
const INPUT_WIDTH = 72;
const COMPUTER = { left: 176, right: 244 };
const SURFACES = { left: 262, width: 56 };

const SOURCE_POSITIONS = { joystick: "upper", rc: "lower" } as const;
const PATH_POSITIONS = { manual: "upper", assisted: "lower" } as const;

/** The path of the control signal: source switch, path switch, on-board computer, surfaces. */
export function ControlPath({ label, description, labels, source, path, autopilot }: Props) {
  const way = signalWay({ source, path, autopilot });
  const computerMiddle = (COMPUTER.left + COMPUTER.right) / 2;
  return (
    <svg
      className="inst-path"
      viewBox="0 14 320 146"
      role="img"
      aria-label={label}
      data-source={source ?? "unknown"}
      data-path={path ?? "unknown"}
      data-automatic={way.automatic}
    >
      <desc>{description}</desc>

      <Wire
        live={way.joystick}
        from={{ x: INPUT_WIDTH + 2, y: UPPER_Y }}
        to={{ x: SOURCE_SWITCH.contactX, y: UPPER_Y }}
      />
      <Wire
        live={way.rc}
        from={{ x: INPUT_WIDTH + 2, y: LOWER_Y }}
        to={{ x: SOURCE_SWITCH.contactX, y: LOWER_Y }}
      />
      <Wire live={way.between} from={SOURCE_SWITCH.pole} to={PATH_SWITCH.pole} />
      <Wire
        live={way.manual}
        from={{ x: PATH_SWITCH.contactX, y: UPPER_Y }}
        to={{ x: SURFACES.left, y: UPPER_Y }}
        arrow
      />
      <Wire
        live={way.assisted}
        from={{ x: PATH_SWITCH.contactX, y: LOWER_Y }}
        to={{ x: COMPUTER.left, y: LOWER_Y }}
        arrow
      />
      <Wire
        live={way.computer}
        from={{ x: COMPUTER.right, y: LOWER_Y }}
        to={{ x: SURFACES.left, y: LOWER_Y }}
        arrow
      />
      <Wire
        live={way.automatic}
        from={{ x: computerMiddle, y: 134 }}
        to={{ x: computerMiddle, y: LOWER_Y + BOX_HEIGHT / 2 }}
        arrow
      />

      <Box
        at={{ x: 2, y: UPPER_Y - BOX_HEIGHT / 2 }}
        width={INPUT_WIDTH}
        height={BOX_HEIGHT}
        live={way.joystick}
        ignored={way.automatic}
        text={labels.joystick}
      />
      <Box
        at={{ x: 2, y: LOWER_Y - BOX_HEIGHT / 2 }}
        width={INPUT_WIDTH}
        height={BOX_HEIGHT}
        live={way.rc}
        ignored={way.automatic}
        text={labels.rc}
      />
      <Box
        at={{ x: COMPUTER.left, y: LOWER_Y - BOX_HEIGHT / 2 }}
        width={COMPUTER.right - COMPUTER.left}
        height={BOX_HEIGHT}
        live={way.computer}
        text={labels.computer}
      />
      <Box
        at={{ x: computerMiddle - 58, y: 134 }}
        width={116}
        height={24}
        live={way.automatic}
        text={labels.autopilot}
      />
      <Box
        at={{ x: SURFACES.left, y: UPPER_Y - BOX_HEIGHT / 2 }}
        width={SURFACES.width}
        height={LOWER_Y - UPPER_Y + BOX_HEIGHT}
        live={way.manual || way.computer}
        text={labels.surfaces}
      />

      <SwitchSymbol
        place={SOURCE_SWITCH}
        position={source === null ? null : SOURCE_POSITIONS[source]}
        live={way.between}
      />
      <SwitchSymbol
        place={PATH_SWITCH}
        position={path === null ? null : PATH_POSITIONS[path]}
        live={way.between}
      />

      <text x="210" y={UPPER_Y - 8} className="inst-path-text" data-live={way.manual}>
        {labels.manual}
      </text>
      <text x="210" y={LOWER_Y - 22} className="inst-path-text" data-live={way.computer}>
        {labels.assisted}
      </text>
      {way.automatic && (
        <text x={INPUT_WIDTH / 2 + 2} y="66" className="inst-path-ignored">
          {labels.ignored}
        </text>
      )}
      {(source === null || path === null) && (
        <text x="123" y="118" className="inst-path-unknown">
          {labels.unknown}
        </text>
      )}
    </svg>
  );
}
