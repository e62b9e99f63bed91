import { Save, Trash2 } from "lucide-react";
import { useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import { usePage, useSettings } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { Dialog } from "../../ui/Dialog";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { DEFAULT_PANES, DEFAULTS, type Layout, type Panes, readLayouts } from "./plotLayouts";

const CHOICE = "plots.layouts";
const MOST_LETTERS = 60;

interface Props {
  readonly panes: Panes;
  readonly onPanes: (panes: Panes) => void;
}

/** Choose a layout, of the station's own or of those that were saved here; save and delete. */
export function LayoutControls({ panes, onPanes }: Props) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const stored = useSettings(({ choices }) => choices[CHOICE]);
  const saved = useMemo(() => readLayouts(stored), [stored]);
  const [isSaving, setSaving] = useState(false);
  const layouts = new Map<string, Panes>([
    ...DEFAULTS.map((name) => [`default ${name}`, DEFAULT_PANES[name]] as const),
    ...saved.map((layout) => [`saved ${layout.name}`, layout.panes] as const),
  ]);
  const shown = JSON.stringify(panes);
  const current = [...layouts].find(([, layout]) => JSON.stringify(layout) === shown)?.[0] ?? null;
  const own = saved.find(({ name }) => `saved ${name}` === current);

  function keep(next: readonly Layout[]): void {
    choose(settings, CHOICE, JSON.stringify(next));
  }

  return (
    <>
      <Select
        label={t("plots.layout")}
        placeholder={t("plots.own")}
        value={current}
        onChange={(key) => onPanes(layouts.get(key) ?? panes)}
        options={[
          ...DEFAULTS.map((name) => ({ value: `default ${name}`, label: t(`plots.defaultLayout.${name}`) })),
          ...saved.map(({ name }) => ({ value: `saved ${name}`, label: name })),
        ]}
      />
      <Button onPress={() => setSaving(true)} icon={<Save aria-hidden="true" size={14} />}>
        {t("plots.save")}
      </Button>
      {own !== undefined && (
        <Button
          onPress={() => keep(saved.filter((layout) => layout !== own))}
          label={t("plots.deleteLayout")}
          icon={<Trash2 aria-hidden="true" size={14} />}
        >
          {null}
        </Button>
      )}
      {isSaving && (
        <SaveDialog
          onSave={(name) => {
            keep([...saved.filter((layout) => layout.name !== name), { name, panes }]);
            setSaving(false);
          }}
          onClose={() => setSaving(false)}
        />
      )}
    </>
  );
}

interface SaveProps {
  readonly onSave: (name: string) => void;
  readonly onClose: () => void;
}

function SaveDialog({ onSave, onClose }: SaveProps) {
  const { t } = useTranslation();
  const [text, setText] = useState("");
  const name = text.trim().slice(0, MOST_LETTERS);
  return (
    <Dialog
      title={t("plots.saveTitle")}
      onClose={onClose}
      actions={
        <Button
          variant="primary"
          onPress={() => onSave(name)}
          disabledReason={name === "" ? t("plots.saveNone") : undefined}
        >
          {t("plots.save")}
        </Button>
      }
    >
      <TextField
        label={t("plots.saveName")}
        value={text}
        onCommit={setText}
        onEdit={setText}
        onEnter={(typed) => typed.trim() !== "" && onSave(typed.trim().slice(0, MOST_LETTERS))}
      />
    </Dialog>
  );
}
