import type { ParseKeys } from "i18next";
import { useTranslation } from "react-i18next";
import { ReadoutGrid } from "../ui/Readout";
import { LiveReadout, type ReadoutLayout, type ReadoutRows } from "./LiveReadout";
import { StreamPanel } from "./StreamPanel";

/** The readouts of a table without its grid, to be combined with others. */
export function Readouts({ topic, rows, chars, size }: ReadoutRows & ReadoutLayout) {
  return rows.map((row) => (
    <LiveReadout key={`${topic}.${row.field}`} topic={topic} chars={chars} size={size} {...row} />
  ));
}

type TableProps = ReadoutRows & ReadoutLayout & { columns?: number };

export function ReadoutTable({ columns, ...rest }: TableProps) {
  return (
    <ReadoutGrid columns={columns}>
      <Readouts {...rest} />
    </ReadoutGrid>
  );
}

/** A panel with the readouts of one stream. */
export type ReadoutGroup = TableProps & {
  titleKey: ParseKeys;
  hintKey?: ParseKeys;
  className: string;
  narrow?: boolean;
  plain?: boolean;
};

export function ReadoutPanel(props: ReadoutGroup) {
  const { titleKey, hintKey, className, narrow = false, plain = false, ...table } = props;
  const { t } = useTranslation();
  return (
    <StreamPanel
      topic={table.topic}
      title={t(titleKey)}
      hint={hintKey === undefined ? undefined : t(hintKey)}
      className={className}
      narrow={narrow}
      plain={plain}
    >
      <ReadoutTable {...table} />
    </StreamPanel>
  );
}
