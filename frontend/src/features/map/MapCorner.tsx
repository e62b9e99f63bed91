import { Compass, House, Maximize } from "lucide-react";
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { CAMERA_CHOICE, cameraOf } from "../../lib/mapCamera";
import { METRES_PER_FOOT, roundLength } from "../../lib/units";
import { coordinate } from "../../readouts/formats";
import { type Unit, useUnit } from "../../readouts/useUnit";
import type { PlaceInSpace } from "../../scene/tools/MapTools";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { aircraftPlace } from "./aircraft/aircraftPlace";
import { useHome } from "./aircraft/useHome";
import { useMapPlan } from "./plan/useMapPlan";
import { useMapTools } from "./scenes/useScreenTools";
import "./tools/tools.css";

/** Greatest length of the scale bar, pixels. */
const LONGEST_PX = 130;

/** Common to both maps: scale, position under the pointer, north, and buttons to go back. */
export function MapCorner() {
  const { t } = useTranslation();
  const [isDrawn, setDrawn] = useState(false);
  return (
    <>
      <ViewButtons />
      {!isDrawn && (
        <p className="map-loading" role="status">
          {t("map.view.loading")}
        </p>
      )}
      <div className="map-legend" hidden={!isDrawn}>
        <ScaleBar onDrawn={setDrawn} />
        <PointerPlace />
      </div>
    </>
  );
}

function ViewButtons() {
  const { t } = useTranslation();
  const { settings, telemetry } = usePage();
  const tools = useMapTools();
  const home = useHome();
  const flight = useMapPlan("flight");
  const hil = useMapPlan("hil");
  const isFree = useSettings(({ choices }) => cameraOf(choices[CAMERA_CHOICE]) === "free");
  const missing = tools === null ? t("map.view.loading") : undefined;
  const icon = { size: 16, "aria-hidden": true } as const;

  function look(places: readonly PlaceInSpace[]): void {
    choose(settings, CAMERA_CHOICE, "free");
    tools?.lookAt(places);
  }

  function everything(): readonly PlaceInSpace[] {
    const aircraft = [aircraftPlace(telemetry, "flight"), aircraftPlace(telemetry, "hil")];
    return [
      ...[...flight.waypoints, ...hil.waypoints].map((waypoint) => ({
        ...waypoint,
        altitude_m: waypoint.altitude_ft * METRES_PER_FOOT,
      })),
      ...aircraft.filter((place) => place !== null),
      { ...home, altitude_m: 0 },
    ];
  }

  return (
    <div className="map-views" role="toolbar" aria-label={t("map.tools.views")}>
      <Button
        onPress={() => tools?.northUp()}
        icon={<Compass {...icon} />}
        label={t("map.tools.northUp")}
        disabledReason={missing ?? (isFree ? undefined : t("map.tools.northFree"))}
      >
        {null}
      </Button>
      <Button
        onPress={() => look([{ ...home, altitude_m: 0 }])}
        icon={<House {...icon} />}
        label={t("map.tools.goHome")}
        disabledReason={missing}
      >
        {null}
      </Button>
      <Button
        onPress={() => look(everything())}
        icon={<Maximize {...icon} />}
        label={t("map.tools.showAll")}
        disabledReason={missing}
      >
        {null}
      </Button>
    </div>
  );
}

/** The scale bar for the middle of the picture, and the north arrow. `onDrawn`: whether there is a picture. */
function ScaleBar({ onDrawn }: { readonly onDrawn: (isDrawn: boolean) => void }) {
  const { t } = useTranslation();
  const tools = useMapTools();
  const distance = useUnit("distance");
  const bar = useRef<HTMLSpanElement>(null);
  const text = useRef<HTMLSpanElement>(null);
  const needle = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    tools?.onScale((scale) => {
      onDrawn(true);
      if (bar.current !== null && text.current !== null && needle.current !== null) {
        const { width_px, length } = barOf(scale.metresPerPixel, distance);
        needle.current.style.transform = `rotate(${(-scale.heading_deg).toFixed(0)}deg)`;
        bar.current.style.width = `${width_px}px`;
        text.current.textContent =
          length === null ? "" : `${Number(length.toPrecision(3))} ${distance.label}`;
      }
    });
    return () => tools?.onScale(null);
  }, [tools, distance, onDrawn]);
  useEffect(() => (tools === null ? undefined : () => onDrawn(false)), [tools, onDrawn]);
  return (
    <span className="map-scale">
      <span ref={needle} className="map-needle" role="img" aria-label={t("map.tools.north")} />
      <span className="map-scale-bar">
        <span ref={text} />
        <span ref={bar} className="map-scale-line" />
      </span>
    </span>
  );
}

/** The longest bar of a round length in the user's unit; null if the scale is unknown. */
function barOf(metresPerPixel: number | null, unit: Unit): { width_px: number; length: number | null } {
  if (metresPerPixel === null || !(metresPerPixel > 0)) {
    return { width_px: 0, length: null };
  }
  const length = roundLength(unit.convert(metresPerPixel * LONGEST_PX));
  return { width_px: unit.revert(length) / metresPerPixel, length };
}

function PointerPlace() {
  const { t } = useTranslation();
  const tools = useMapTools();
  const altitude = useUnit("altitude", "m");
  const text = useRef<HTMLSpanElement>(null);
  const deg = t("unit.deg");
  const dash = t("words.dash");
  const ground = t("map.tools.ground");
  useEffect(
    () =>
      tools?.onHover((place) => {
        if (text.current === null) return;
        const height =
          place === null || place.height_m === null
            ? ""
            : ` · ${ground} ${altitude.format(place.height_m)} ${altitude.label}`;
        text.current.textContent =
          place === null
            ? dash
            : `${coordinate(place.latitude_deg)}${deg} ${coordinate(place.longitude_deg)}${deg}${height}`;
      }),
    [tools, altitude, deg, dash, ground],
  );
  return (
    <span className="map-pointer" aria-label={t("map.tools.pointer")} role="img">
      <span ref={text}>{dash}</span>
    </span>
  );
}
