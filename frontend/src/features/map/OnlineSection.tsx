import { Eraser, Trash2, Undo2 } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useSentence } from "../../i18n/useSentence";
import { formatBytes } from "../../lib/format";
import type { MapOnline, OnlineChoice, OnlineSource } from "../../protocol/mapLayers";
import { useAsked } from "../../requests/useAsked";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { failureMessage } from "../../store/messages";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { Notice } from "../../ui/Notice";
import { NumberField } from "../../ui/NumberField";
import { EditScope } from "../../ui/openEdits";
import { MAP_LAYERS, useMapLayers } from "./layers/layerList";
import { SourceForm } from "./layers/SourceForm";
import { FoldingPanel } from "./panels/FoldingPanel";

const BYTES_PER_MB = 1_000_000;
const MOST_MB = 100_000;
const CONTROL = "map.online";

type Source = OnlineChoice["sources"][number];

/** Online maps: off until the user has read what that means and switched them on. */
export function OnlineSection() {
  const { t } = useTranslation();
  const online = useMapLayers((known) => known.online);
  return (
    <FoldingPanel name="online" title={t("map.online.title")} className="map-layers">
      {online === null ? (
        <p className="map-layers-hint">{t("map.online.unknown")}</p>
      ) : (
        <Online online={online} />
      )}
    </FoldingPanel>
  );
}

function Online({ online }: { online: MapOnline }) {
  const { t } = useTranslation();
  const mapLayers = usePart(MAP_LAYERS);
  const blocked = useGatewayBlocked();
  const { state, stateText } = useAsked(CONTROL);
  const [isAsking, setAsking] = useState(false);
  const [removed, setRemoved] = useState<Source | null>(null);

  function put(change: Partial<OnlineChoice>): void {
    const sources = (change.sources ?? online.sources).map(plain);
    const { enabled, limit_bytes } = online;
    void mapLayers.chooseOnline({ enabled, limit_bytes, ...change, sources }, { control: CONTROL });
  }

  return (
    <>
      <Checkbox
        label={t("map.online.enable")}
        checked={online.enabled}
        onChange={(isOn) => (isOn ? setAsking(true) : put({ enabled: false }))}
        disabledReason={blocked}
      />
      <p className="map-layers-hint">{online.enabled ? t("map.online.on") : t("map.online.off")}</p>
      {(state === "rejected" || state === "timed_out") && <Notice level="error">{stateText}</Notice>}
      <ul className="map-layers-list">
        {online.sources.map((source) => (
          <SourceRow
            key={source.id}
            source={source}
            blocked={blocked}
            onRemove={() => {
              setRemoved(plain(source));
              put({ sources: online.sources.filter(({ id }) => id !== source.id) });
            }}
          />
        ))}
      </ul>
      {removed !== null && (
        <Button
          onPress={() => {
            put({ sources: [...online.sources, removed] });
            setRemoved(null);
          }}
          icon={<Undo2 size={14} aria-hidden="true" />}
          disabledReason={blocked}
        >
          {t("map.online.restore", { name: removed.name })}
        </Button>
      )}
      <EditScope>
        <SourceForm
          taken={online.sources.map(({ id }) => id)}
          blocked={blocked}
          onAdd={(source) => put({ sources: [...online.sources, source] })}
        />
      </EditScope>
      <NumberField
        label={t("map.online.limit")}
        value={Math.round(online.limit_bytes / BYTES_PER_MB)}
        minimum={0}
        maximum={MOST_MB}
        step={100}
        unit={t("map.online.megabytes")}
        onCommit={(limit) => put({ limit_bytes: limit * BYTES_PER_MB })}
        disabledReason={blocked}
      />
      <Cached bytes={online.cached_bytes} blocked={blocked} />
      {isAsking && (
        <ConfirmDialog
          title={t("map.online.askTitle")}
          text={t("map.online.askText")}
          confirmLabel={t("map.online.askYes")}
          cancelLabel={t("map.online.askNo")}
          onConfirm={() => {
            setAsking(false);
            put({ enabled: true });
          }}
          onCancel={() => setAsking(false)}
        />
      )}
    </>
  );
}

function SourceRow({
  source,
  blocked,
  onRemove,
}: {
  source: OnlineSource;
  blocked: string | undefined;
  onRemove: () => void;
}) {
  const { t } = useTranslation();
  const sentence = useSentence();
  const { name, url, attribution, problem, problem_code, problem_params } = source;
  return (
    <li className="map-layer">
      <div className="map-layer-head">
        <span>{name}</span>
        <Button
          onPress={onRemove}
          icon={<Trash2 size={14} aria-hidden="true" />}
          label={t("map.online.remove", { name })}
          disabledReason={blocked}
        >
          {null}
        </Button>
      </div>
      <p className="map-layers-hint">{`${url} · ${attribution}`}</p>
      {problem !== null && (
        <Notice level="warning">
          {sentence(failureMessage({ code: problem_code ?? "", detail: problem, params: problem_params }))}
        </Notice>
      )}
    </li>
  );
}

function Cached({ bytes, blocked }: { bytes: number; blocked: string | undefined }) {
  const { t } = useTranslation();
  const mapLayers = usePart(MAP_LAYERS);
  const { state, stateText } = useAsked("map.online.clear");
  const [isAsking, setAsking] = useState(false);
  return (
    <>
      <p>{t("map.online.cached", { bytes: formatBytes(bytes) })}</p>
      <Button
        onPress={() => setAsking(true)}
        icon={<Eraser size={14} aria-hidden="true" />}
        state={state}
        stateText={stateText}
        disabledReason={blocked ?? (bytes === 0 ? t("map.online.nothing") : undefined)}
      >
        {t("map.online.clear")}
      </Button>
      {isAsking && (
        <ConfirmDialog
          title={t("map.online.clearTitle")}
          text={t("map.online.clearText")}
          confirmLabel={t("map.online.clearYes")}
          cancelLabel={t("map.online.keep")}
          danger
          onConfirm={() => {
            setAsking(false);
            void mapLayers.clearOnline({ control: "map.online.clear" });
          }}
          onCancel={() => setAsking(false)}
        />
      )}
    </>
  );
}

function plain({ id, name, url, attribution, maximum_zoom }: Source): Source {
  return { id, name, url, attribution, maximum_zoom };
}
