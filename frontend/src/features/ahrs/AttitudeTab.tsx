import { useState } from "react";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { AttitudePicture, type CameraChoice, type PictureSettings } from "./AttitudePicture";
import { NumbersPanel } from "./NumbersPanel";
import { ShowPanel } from "./ShowPanel";
import { SourcePanel } from "./SourcePanel";
import { useAttitudeSource } from "./source";

/** The parts of the picture that can be hidden, by their names in the settings; all are shown at first. */
export const SHOWN = ["ghost", "bodyAxes", "worldAxes", "vectors"] as const;

/** The picture of the attitude, and beside it its source, its numbers and what it shows. */
export function AttitudeTab() {
  const { settings } = usePage();
  const source = useAttitudeSource();
  const hidden = useSettings(({ choices }) => choices["ahrs3dHidden"] ?? "");
  const follow = useSettings(({ choices }) => choices["ahrs3dFollow"] === "on");
  const [camera, setCamera] = useState<CameraChoice>({ view: "behind", pressed: 0 });
  const isShown = (name: (typeof SHOWN)[number]): boolean => !hidden.split(" ").includes(name);
  const shown: PictureSettings = {
    ghost: isShown("ghost"),
    bodyAxes: isShown("bodyAxes"),
    worldAxes: isShown("worldAxes"),
    vectors: isShown("vectors"),
    follow,
  };
  const toggle = (name: (typeof SHOWN)[number], isOn: boolean): void =>
    choose(
      settings,
      "ahrs3dHidden",
      SHOWN.filter((each) => (each === name ? !isOn : !isShown(each))).join(" "),
    );
  return (
    <div className="ahrs3d-body">
      <AttitudePicture
        source={source}
        settings={shown}
        camera={camera}
        onCamera={(view) => setCamera(({ pressed }) => ({ view, pressed: pressed + 1 }))}
        onFree={() => setCamera(({ pressed }) => ({ view: null, pressed }))}
      />
      <div className="ahrs3d-side">
        <SourcePanel source={source} />
        <NumbersPanel
          source={source}
          onAligned={() => setCamera(({ view, pressed }) => ({ view, pressed: pressed + 1 }))}
        />
        <ShowPanel
          settings={shown}
          onToggle={toggle}
          onFollow={(isOn) => choose(settings, "ahrs3dFollow", isOn ? "on" : "off")}
        />
      </div>
    </div>
  );
}
