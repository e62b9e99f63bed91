import { Plus } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import type { OnlineChoice } from "../../../protocol/mapLayers";
import { Button } from "../../../ui/Button";
import { NumberField } from "../../../ui/NumberField";
import { TextField } from "../../../ui/TextField";
import { addressFault, sourceId } from "./mapStack";

type Source = OnlineChoice["sources"][number];

interface Props {
  /** Ids in use. */
  taken: readonly string[];
  blocked: string | undefined;
  onAdd: (source: Source) => void;
}

const EMPTY = { name: "", url: "", attribution: "", maximum_zoom: 19 };
const DEEPEST_ZOOM = 24;

/** A form for another online source, checked before it is sent. */
export function SourceForm({ taken, blocked, onAdd }: Props) {
  const { t } = useTranslation();
  const [draft, setDraft] = useState(EMPTY);
  const { name, url, attribution, maximum_zoom } = draft;
  const fault = addressFault(url.trim());
  const urlFault =
    fault === null
      ? undefined
      : {
          scheme: t("map.online.scheme"),
          places: t("map.online.places"),
          unreadable: t("map.online.unreadable"),
        }[fault];
  const id = sourceId(name);
  const reason =
    blocked ??
    (id === ""
      ? t("map.online.needName")
      : taken.includes(id)
        ? t("map.online.taken")
        : (urlFault ?? (attribution.trim() === "" ? t("map.online.needAttribution") : undefined)));
  return (
    <div className="map-source-form">
      <TextField
        label={t("map.online.name")}
        value={name}
        onEdit={(text) => setDraft({ ...draft, name: text })}
        onCommit={(text) => setDraft({ ...draft, name: text })}
      />
      <TextField
        label={t("map.online.url")}
        value={url}
        monospace
        placeholder={t("map.online.urlExample")}
        error={url.trim() === "" ? undefined : urlFault}
        onEdit={(text) => setDraft({ ...draft, url: text })}
        onCommit={(text) => setDraft({ ...draft, url: text })}
      />
      <TextField
        label={t("map.online.attribution")}
        value={attribution}
        onEdit={(text) => setDraft({ ...draft, attribution: text })}
        onCommit={(text) => setDraft({ ...draft, attribution: text })}
      />
      <NumberField
        label={t("map.online.zoom")}
        value={maximum_zoom}
        minimum={0}
        maximum={DEEPEST_ZOOM}
        step={1}
        onCommit={(value) => setDraft({ ...draft, maximum_zoom: Math.round(value) })}
      />
      <Button
        takesFields
        onPress={() => {
          onAdd({ id, name: name.trim(), url: url.trim(), attribution: attribution.trim(), maximum_zoom });
          setDraft(EMPTY);
        }}
        icon={<Plus size={14} aria-hidden="true" />}
        disabledReason={reason}
      >
        {t("map.online.add")}
      </Button>
    </div>
  );
}
