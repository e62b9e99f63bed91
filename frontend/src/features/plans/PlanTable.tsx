import { CircleAlert, Navigation, TriangleAlert } from "lucide-react";
import { useTranslation } from "react-i18next";
import { formatFixed, formatHeading } from "../../lib/format";
import { type Leg, legsOf, WAYPOINT_FIELDS, type Waypoint, type WaypointField } from "../../lib/plan";
import type { PlanIssue } from "../../lib/planCheck";
import { COLUMN } from "../../missions/planFacts";
import { useIssueText } from "../../missions/useIssueText";
import { type Unit, useUnit } from "../../readouts/useUnit";
import { PlanCell } from "./PlanCell";

interface Props {
  waypoints: readonly Waypoint[];
  issues: readonly PlanIssue[];
  active: number | null;
  /** All selected rows. */
  selected: readonly number[];
  /** A plan of the past: its cells are only read. */
  isFixed: boolean;
  /** What an altitude was converted from; null if it was not. */
  originText: (waypoint: Waypoint) => string | null;
  onSelect: (row: number, field: WaypointField) => void;
  onEdit: (row: number, field: WaypointField, value: number) => void;
  /** Move the cursor to another cell. */
  onGo: (row: number, field: WaypointField) => void;
}

/** The waypoints of a plan as an editable table, with the leg from each to the next. */
export function PlanTable(props: Props) {
  const { waypoints, issues, active, selected, isFixed, originText, onSelect, onEdit, onGo } = props;
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const speed = useUnit("speed");
  const distance = useUnit("distance");
  const legs = legsOf(waypoints);
  const units: Readonly<Record<WaypointField, Unit | null>> = {
    latitude_deg: null,
    longitude_deg: null,
    altitude_ft: altitude,
    speed_kt: speed,
  };
  return (
    <table className="plans-table">
      <caption className="visually-hidden">{t("plans.table")}</caption>
      <thead>
        <tr>
          <th scope="col">{t("plans.number")}</th>
          <Head title={t("plans.latitude")} unit={t("unit.deg")} />
          <Head title={t("plans.longitude")} unit={t("unit.deg")} />
          <Head
            title={t("plans.altitude")}
            unit={`${altitude.label} ${t("plans.amsl")}`}
            hint={t("plans.amslHint")}
          />
          <Head title={t("plans.speed")} unit={speed.label} />
          <Head title={t("plans.distance")} unit={distance.label} hint={t("plans.toNext")} />
          <Head title={t("plans.bearing")} unit={t("unit.deg")} hint={t("plans.toNext")} />
          <Head title={t("plans.climb")} unit={t("unit.deg")} hint={t("plans.toNext")} />
        </tr>
      </thead>
      <tbody>
        {rowsOf(waypoints, legs, issues).map(({ index, waypoint, leg, found }) => (
          <tr
            key={index}
            data-selected={selected.includes(index)}
            data-active={active === index}
            data-level={worst(found)}
          >
            <RowHead index={index} isActive={active === index} found={found} />
            {WAYPOINT_FIELDS.map((field) => (
              <td key={field}>
                <Cell
                  {...{ index, field, waypoint, found, isFixed }}
                  unit={units[field]}
                  onEdit={onEdit}
                  onSelect={onSelect}
                  onMove={(by) => {
                    const row = index + by;
                    if (row >= 0 && row < waypoints.length) onGo(row, field);
                  }}
                />
                {field === "altitude_ft" && <Origin text={originText(waypoint)} />}
              </td>
            ))}
            <td className="plans-figure">
              {leg === null ? t("words.dash") : distance.format(leg.distance_m)}
            </td>
            <td className="plans-figure">{formatHeading(leg?.bearing_deg, 1) ?? t("words.dash")}</td>
            <td className="plans-figure">{climbText(leg) ?? t("words.dash")}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Head({ title, unit, hint }: { title: string; unit: string; hint?: string }) {
  return (
    <th scope="col" title={hint}>
      {title} <span className="plans-unit">{unit}</span>
    </th>
  );
}

function Origin({ text }: { text: string | null }) {
  return text === null ? null : <span className="plans-origin">{text}</span>;
}

interface Row {
  readonly index: number;
  readonly waypoint: Waypoint;
  /** The leg to the next; null at the last. */
  readonly leg: Leg | null;
  readonly found: readonly PlanIssue[];
}

function rowsOf(
  waypoints: readonly Waypoint[],
  legs: readonly Leg[],
  issues: readonly PlanIssue[],
): readonly Row[] {
  return waypoints.map((waypoint, index) => ({
    index,
    waypoint,
    leg: legs[index] ?? null,
    found: issues.filter(({ row }) => row === index),
  }));
}

function RowHead({
  index,
  isActive,
  found,
}: {
  index: number;
  isActive: boolean;
  found: readonly PlanIssue[];
}) {
  const { t } = useTranslation();
  const issueText = useIssueText();
  const level = worst(found);
  return (
    <th scope="row" className="plans-number" title={found.map(issueText).join(" ") || undefined}>
      {index + 1}
      {isActive && (
        <>
          <Navigation size={12} aria-hidden="true" className="plans-active" />
          <span className="visually-hidden">{t("plans.active")}</span>
        </>
      )}
      {level === "error" && <CircleAlert size={13} aria-hidden="true" />}
      {level === "warning" && <TriangleAlert size={13} aria-hidden="true" />}
    </th>
  );
}

interface CellProps {
  index: number;
  field: WaypointField;
  waypoint: Waypoint;
  found: readonly PlanIssue[];
  isFixed: boolean;
  unit: Unit | null;
  onEdit: Props["onEdit"];
  onSelect: Props["onSelect"];
  onMove: (by: -1 | 1) => void;
}

function Cell({ index, field, waypoint, found, isFixed, unit, onEdit, onSelect, onMove }: CellProps) {
  const { t } = useTranslation();
  const issueText = useIssueText();
  const fault = found.find((issue) => issue.field === field && issue.level === "error");
  return (
    <PlanCell
      label={t("plans.cell", { column: t(`plans.${COLUMN[field]}`), number: index + 1 })}
      text={(unit === null ? formatFixed(waypoint[field], 6) : unit.format(waypoint[field])) ?? ""}
      row={index}
      field={field}
      isReadOnly={isFixed}
      largest={field === "latitude_deg" || field === "longitude_deg" ? 180 : Number.POSITIVE_INFINITY}
      fault={fault === undefined ? null : issueText(fault)}
      onCommit={(shown) => onEdit(index, field, unit === null ? shown : unit.revert(shown))}
      onMove={onMove}
      onFocus={() => onSelect(index, field)}
    />
  );
}

function worst(found: readonly PlanIssue[]): PlanIssue["level"] | "none" {
  if (found.some(({ level }) => level === "error")) {
    return "error";
  }
  return found.length > 0 ? "warning" : "none";
}

/** A climb with its sign: "+3.2", "-1.2", "0.0". */
function climbText(leg: Leg | null): string | null {
  const text = formatFixed(leg?.climb_deg, 1);
  return text !== null && Number(text) > 0 ? `+${text}` : text;
}
