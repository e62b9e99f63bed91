import { Plus, Trash2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { legPlace } from "../../../lib/plan";
import { PlaceField } from "../../../missions/PlaceField";
import { usePart } from "../../../store/hooks";
import { Button } from "../../../ui/Button";
import { Select } from "../../../ui/Select";
import { MOST_CORNERS, SURROUNDINGS } from "./surroundings";
import { useFixed, useSurroundings } from "./useSurroundings";

/** One corner of the fence by its number: its place typed, another put behind it, or taken away. */
export function OneCorner() {
  const { t } = useTranslation();
  const { edit } = usePart(SURROUNDINGS);
  const corners = useSurroundings((state) => state.corners.present);
  const fixed = useFixed();
  const [chosen, setChosen] = useState(0);
  // Another may have taken corners away meanwhile.
  const index = Math.min(chosen, corners.length - 1);
  const corner = corners[index];
  const next = corners[(index + 1) % corners.length];
  if (corner === undefined || next === undefined) {
    return null;
  }
  const number = index + 1;
  const full = corners.length >= MOST_CORNERS ? t("map.around.full", { most: MOST_CORNERS }) : undefined;
  return (
    <div className="map-around-corner">
      <Select
        label={t("map.around.corner")}
        placeholder={t("map.around.corner")}
        value={String(index)}
        onChange={(value) => setChosen(Number(value))}
        options={corners.map((_, at) => ({
          value: String(at),
          label: t("map.around.cornerNumber", { number: at + 1 }),
        }))}
      />
      <PlaceField
        key={index}
        place={corner}
        fixed={fixed}
        onCommit={({ latitude_deg, longitude_deg }) =>
          edit(corners.with(index, { latitude_deg, longitude_deg }))
        }
      />
      <div className="map-plan-buttons">
        <Button
          onPress={() => {
            const { latitude_deg, longitude_deg } = legPlace(corner, next, 0.5);
            edit(corners.toSpliced(index + 1, 0, { latitude_deg, longitude_deg }));
            setChosen(index + 1);
          }}
          icon={<Plus size={14} aria-hidden="true" />}
          disabledReason={fixed ?? full}
        >
          {t("map.around.insertCorner", { number })}
        </Button>
        <Button
          onPress={() => edit(corners.toSpliced(index, 1))}
          icon={<Trash2 size={14} aria-hidden="true" />}
          disabledReason={fixed}
        >
          {t("map.around.removeCorner", { number })}
        </Button>
      </div>
    </div>
  );
}
