import { type ReactNode, useCallback, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { useOriginText } from "../../missions/altitudeOrigin";
import { PlaceField } from "../../missions/PlaceField";
import { MISSIONS, notePlan, usePlans } from "../../missions/planDrafts";
import { ReplaceDialog } from "../../missions/ReplaceDialog";
import { SELECTION, selectThing } from "../../missions/selection";
import { useNoTransfer } from "../../missions/useNoTransfer";
import { type ShownPlan, usePlan } from "../../missions/usePlan";
import type { PlanName } from "../../protocol/missions";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Notice } from "../../ui/Notice";
import { EditScope } from "../../ui/openEdits";
import { PlanHead } from "./PlanHead";
import { PlanIssues } from "./PlanIssues";
import { PlanTable } from "./PlanTable";
import { PlanTools } from "./PlanTools";
import { RowTools } from "./RowTools";
import { useEditing } from "./useEditing";

/** One of the two plans: its table, its map, what is wrong with it, and the ways to and from board and files. */
export function PlanEditor({ plan, map }: { plan: PlanName; map: ReactNode }) {
  return (
    <EditScope>
      <Editor plan={plan} map={map} />
    </EditScope>
  );
}

function Editor({ plan, map }: { plan: PlanName; map: ReactNode }) {
  const { t } = useTranslation();
  const shown = usePlan(plan);
  const { waypoints } = shown;
  const originText = useOriginText(plan);
  const noTransfer = useNoTransfer().long;
  const selection = usePart(SELECTION);
  const thing = useStore(selection, (now) => now.thing);
  const chosen = thing?.kind === "waypoint" && thing.plan === plan ? thing.row : null;
  const selected = chosen !== null && chosen < waypoints.length ? chosen : null;
  const rows = useStore(selection, (now) => now.rows);
  const setChosen = useCallback(
    (row: number | null) => selectThing(selection, row === null ? null : { kind: "waypoint", plan, row }),
    [selection, plan],
  );
  const [question, setQuestion] = useState<(() => void) | null>(null);
  const edit = useEditing(plan, selected, setChosen);

  return (
    <div className="plans-editor">
      <PlanTools
        plan={plan}
        shown={shown}
        selected={selected}
        onReplace={(replace) => {
          const isUnsent = waypoints.length > 0 && shown.state !== "same";
          if (isUnsent) setQuestion(() => replace);
          else replace();
        }}
      />
      <PlanHead shown={shown} />
      {noTransfer !== undefined && !shown.isFixed && <Notice level="info">{noTransfer}</Notice>}
      <TransferOutcome plan={plan} />
      <div className="plans-body">
        <div className="plans-main">
          <RowTools
            plan={plan}
            selected={selected}
            count={waypoints.length}
            isFixed={shown.isFixed}
            edit={edit}
          />
          {/* biome-ignore lint/a11y/noStaticElementInteractions: the keys are those of the cells within */}
          <div ref={edit.box} className="plans-box" onKeyDown={edit.onKeyDown}>
            {waypoints.length === 0 ? (
              <p className="plans-empty">{t(emptyWords(shown))}</p>
            ) : (
              <PlanTable
                waypoints={waypoints}
                issues={shown.issues}
                active={shown.active}
                selected={selected === null ? [] : rows}
                isFixed={shown.isFixed}
                originText={originText}
                onSelect={setChosen}
                onEdit={edit.change}
                onGo={edit.go}
              />
            )}
          </div>
          {selected !== null && waypoints[selected] !== undefined && (
            <PlaceField
              key={selected}
              place={waypoints[selected]}
              fixed={shown.isFixed ? t("plans.fixed") : undefined}
              onCommit={(place) => edit.place(selected, place)}
            />
          )}
          <p className="plans-keys">{t(shown.isFixed ? "plans.fixed" : "plans.keys")}</p>
        </div>
        <aside className="plans-side" aria-label={t("plans.issues")}>
          {map}
          <PlanIssues issues={shown.issues} onGo={edit.go} />
        </aside>
      </div>
      {question !== null && <ReplaceDialog onConfirm={question} onClose={() => setQuestion(null)} />}
    </div>
  );
}

function emptyWords({ isFixed, state }: ShownPlan) {
  if (!isFixed) {
    return "plans.empty";
  }
  return state === "unknown" ? "plans.pastUnknown" : "plans.pastEmpty";
}

/** The outcome of the last transfer or file, and the assumptions made in reading a file. */
function TransferOutcome({ plan }: { plan: PlanName }) {
  const sentence = useSentence();
  const missions = usePart(MISSIONS);
  const notes = usePlans((plans) => plans[plan].notes);
  const failures = [
    useAsked(`plan.download.${plan}`),
    useAsked(`plan.upload.${plan}`),
    useAsked(`plan.goTo.${plan}`),
    useAsked(`plan.import.${plan}`),
    useAsked(`plan.export.${plan}`),
  ].filter(({ state }) => state === "rejected" || state === "timed_out");
  return (
    <>
      {failures.map(({ stateText }) => (
        <Notice key={stateText} level="error">
          {stateText}
        </Notice>
      ))}
      {notes.length > 0 && (
        <Notice level="warning" onDismiss={() => notePlan(missions.plans, plan, [])}>
          {notes.map((note) => (
            <p key={`${note.key} ${note.params["name"] ?? ""}`}>{sentence(note)}</p>
          ))}
        </Notice>
      )}
    </>
  );
}
