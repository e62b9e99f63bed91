import { ArrowDown, ArrowUp, Search, X } from "lucide-react";
import { useId } from "react";
import { useTranslation } from "react-i18next";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { DateField } from "../../ui/DateField";
import { Select } from "../../ui/Select";
import { FLIGHTS } from "./flightLibrary";
import { ALL_FLIGHTS, isFiltered, SORTS } from "./flightQuery";
import { useLibrary } from "./useFlights";

/** A choice of the list that does not narrow it. */
const ANY = "";

/** What the list is narrowed by, and where the library tells all there is of it. */
const NAMED = [
  { name: "tag", words: "tags" },
  { name: "board", words: "boards" },
  { name: "aircraft", words: "all_aircraft" },
  { name: "operator", words: "operators" },
] as const;

/** Which flights are listed, and in which order. */
export function FlightFilters() {
  const { t } = useTranslation();
  const { ask } = usePart(FLIGHTS);
  const query = useLibrary((library) => library.query);
  const list = useLibrary((library) => library.list);
  const any = { value: ANY, label: t("flights.any") };
  const isUp = query.order === "asc";
  return (
    <search className="flights-filters" aria-label={t("flights.search")}>
      <SearchField />
      <DateField
        label={t("flights.from")}
        form={t("flights.day")}
        value={query.from}
        onChange={(from) => ask({ from })}
      />
      <DateField
        label={t("flights.to")}
        form={t("flights.day")}
        value={query.to}
        onChange={(to) => ask({ to })}
      />
      {NAMED.map(({ name, words }) => (
        <Select
          key={name}
          label={t(`flights.${name}`)}
          placeholder={t("flights.any")}
          value={query[name] ?? ANY}
          options={[any, ...known(list?.[words] ?? [], query[name])]}
          onChange={(chosen) => ask({ [name]: chosen === ANY ? null : chosen })}
        />
      ))}
      <Select
        label={t("flights.sort")}
        placeholder={t("flights.sort")}
        value={query.sort}
        options={SORTS.map((sort) => ({ value: sort, label: t(`flightSort.${sort}`) }))}
        onChange={(sort) => ask({ sort })}
      />
      <Button
        onPress={() => ask({ order: isUp ? "desc" : "asc" })}
        icon={isUp ? <ArrowUp size={15} aria-hidden="true" /> : <ArrowDown size={15} aria-hidden="true" />}
        label={isUp ? t("flights.ascending") : t("flights.descending")}
      >
        {null}
      </Button>
      {isFiltered(query) && (
        <Button
          onPress={() => ask({ ...ALL_FLIGHTS, sort: query.sort, order: query.order })}
          icon={<X size={14} aria-hidden="true" />}
        >
          {t("flights.clear")}
        </Button>
      )}
    </search>
  );
}

/** All that the library has, and what was asked for even if nothing has it any more. */
function known(words: readonly string[], chosen: string | null): { value: string; label: string }[] {
  const all = chosen === null || words.includes(chosen) ? words : [chosen, ...words];
  return all.map((word) => ({ value: word, label: word }));
}

/** Searches a moment after the last key. */
function SearchField() {
  const { t } = useTranslation();
  const { search } = usePart(FLIGHTS);
  const text = useLibrary(({ query }) => query.text);
  const id = useId();
  return (
    <div className="ui-field flights-search">
      <label htmlFor={id} className="ui-field-label">
        {t("flights.text")}
      </label>
      <span className="ui-field-box">
        <Search size={14} aria-hidden="true" className="flights-search-icon" />
        <input
          id={id}
          type="search"
          className="ui-field-input flights-search-input"
          autoComplete="off"
          maxLength={200}
          value={text}
          placeholder={t("flights.textHint")}
          onChange={(event) => search(event.currentTarget.value)}
        />
      </span>
    </div>
  );
}
