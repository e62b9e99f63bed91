import { useState } from "react";
import { useTranslation } from "react-i18next";
import { plain } from "../../lib/plain";
import { PARAMETERS, type ParameterInfo, type ParameterName } from "../../protocol/messages.gen";
import { Notice } from "../../ui/Notice";
import { Panel } from "../../ui/Panel";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { type Diff, DiffDialog } from "./DiffDialog";
import { type Filter, passes } from "./gainFilter";
import { Journal } from "./Journal";
import { OwnGains, OwnTableState, useGroupName } from "./OwnGains";
import { ParameterRow } from "./ParameterRow";
import { ParamsTools, Stored } from "./ParamsTools";
import { useParameters } from "./parameterValues";
import "./params.css";
import { INFO, useFreshParameters } from "./useFreshParameters";

const GROUPS = ["altitude", "heading", "rudder", "speed"] as const;

/**
 * "Autopilot Param": the 17 gains as the board has them, each edited by itself, and the ways to change several; then
 * those that the board describes itself.
 */
export function ParamsView() {
  const { t } = useTranslation();
  const held = useParameters((values) => values.held);
  const own = useParameters((values) => values.own);
  const groupName = useGroupName();
  const [diff, setDiff] = useState<Diff | null>(null);
  const [search, setSearch] = useState("");
  const [filter, setFilter] = useState<Filter>("all");
  useFreshParameters();

  const texts = (name: ParameterName, { group }: ParameterInfo): string =>
    `${name} ${t(`paramDoc.${name}`)} ${t(`paramGroup.${group}`)}`;
  // Within a group they stand in the order of the table in which pilots know them.
  const finds = (text: string): boolean => plain(text).includes(plain(search.trim()));
  const shown = ORDER.filter(
    (name) => passes(filter, held[name], INFO[name].default) && finds(texts(name, INFO[name])),
  );
  const ownShown = own.table.gains.filter(
    ({ name, doc, group, default: standard }) =>
      passes(filter, own.values[name] ?? { value: null, loaded: null }, standard) &&
      finds(`${name} ${doc} ${groupName(group)}`),
  );
  const isUnknown = PARAMETERS.every(({ name }) => held[name].value === null);
  const count = (kind: "default" | "changed"): number =>
    ORDER.filter((name) => passes(kind, held[name], INFO[name].default)).length;

  return (
    <div className="params">
      <ParamsTools onDiff={setDiff} />
      <div className="params-find">
        <TextField
          label={t("params.search")}
          value={search}
          onCommit={setSearch}
          onEdit={setSearch}
          hideLabel
          placeholder={t("params.search")}
        />
        <Select
          label={t("params.show")}
          hideLabel
          placeholder={t("params.show")}
          value={filter}
          onChange={setFilter}
          options={[
            { value: "all", label: t("params.showAll") },
            { value: "default", label: t("params.showDefault") },
            { value: "changed", label: t("params.showChanged") },
          ]}
        />
        <p className="params-summary" role="status">
          {isUnknown ? "" : t("params.summary", { byDefault: count("default"), byLoad: count("changed") })}
        </p>
        <Stored />
      </div>
      {isUnknown && <Notice level="info">{t("params.unknownAll")}</Notice>}
      <div className="params-groups">
        {GROUPS.map((group) => {
          const names = shown.filter((name) => INFO[name].group === group);
          return names.length === 0 ? null : (
            <Panel key={group} title={t(`paramGroup.${group}`)} className={`params-${group}`}>
              {names.map((name) => (
                <ParameterRow
                  key={name}
                  name={name}
                  onReset={() => setDiff({ kind: "reset", gains: [INFO[name]] })}
                />
              ))}
            </Panel>
          );
        })}
      </div>
      <OwnTableState />
      <div className="params-own-groups">
        <OwnGains gains={ownShown} />
      </div>
      {shown.length + ownShown.length === 0 && <p className="params-none">{t("params.noneShown")}</p>}
      <Journal />
      {diff !== null && <DiffDialog diff={diff} onClose={() => setDiff(null)} />}
    </div>
  );
}

/** The order of the table of parameters: inner loops first. */
const ORDER: readonly ParameterName[] = [
  "k_elev",
  "k_int_pitch",
  "k_div_Q_init",
  "k_div_Q_speed",
  "k_pitch",
  "k_altura",
  "k_int_altura",
  "k_VVI",
  "k_airln",
  "k_div_P_init",
  "k_div_P_speed",
  "k_roll",
  "k_heading",
  "k_rudder",
  "k_div_R_init",
  "k_div_R_speed",
  "k_div_velocidad",
];
