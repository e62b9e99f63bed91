import { useTranslation } from "react-i18next";
import { Checkbox } from "../../ui/Checkbox";
import { Panel } from "../../ui/Panel";
import type { PictureSettings } from "./AttitudePicture";

type Part = "ghost" | "bodyAxes" | "worldAxes" | "vectors";
const PARTS = [
  ["ghost", "ahrs3d.part.ghost"],
  ["bodyAxes", "ahrs3d.part.bodyAxes"],
  ["worldAxes", "ahrs3d.part.worldAxes"],
  ["vectors", "ahrs3d.part.vectors"],
] as const satisfies ReadonlyArray<readonly [Part, string]>;

interface Props {
  settings: PictureSettings;
  onToggle: (part: Part, isOn: boolean) => void;
  onFollow: (isOn: boolean) => void;
}

/** Switches for the parts of the picture. */
export function ShowPanel({ settings, onToggle, onFollow }: Props) {
  const { t } = useTranslation();
  return (
    <Panel title={t("ahrs3d.show")}>
      <div className="ahrs3d-show">
        <Checkbox label={t("ahrs3d.follow")} checked={settings.follow} onChange={onFollow} />
        {PARTS.map(([part, word]) => (
          <Checkbox
            key={part}
            label={t(word)}
            checked={settings[part]}
            onChange={(isOn) => onToggle(part, isOn)}
          />
        ))}
      </div>
    </Panel>
  );
}
