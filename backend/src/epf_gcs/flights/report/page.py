"""The report as a page of its own: HTML with everything in it, ready for print, in both languages."""

from __future__ import annotations

from datetime import UTC, datetime
from html import escape
from typing import Any, Final

from epf_gcs.contract.report import FlightReport, ReportEvent
from epf_gcs.flights.report.picture import picture
from epf_gcs.flights.report.rows import ANSWER, BATTERY, LEG, LINK, MODEL, TIMES, Flown, Row, clock, gain_rows
from epf_gcs.flights.report.words import Words
from epf_gcs.flights.report.words import words as words_of

_STYLE: Final = """
@page { size: A4; margin: 14mm }
body { font: 10.5pt/1.4 system-ui, sans-serif; color: #000; background: #fff; max-width: 60rem; margin: 2rem auto;
  padding: 0 1rem }
h2 { margin-top: 1.4em; border-bottom: 1px solid #999; break-after: avoid }
h3 { margin: 0 0 .3em; break-after: avoid }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
th, td { padding: 2px 10px 2px 0; border-bottom: 1px solid #ccc; text-align: left; font-weight: 400 }
td { text-align: right }
thead th { font-weight: 600 }
thead th:not(:first-child) { text-align: right }
tr { break-inside: avoid }
figure { margin: 0 } figcaption { color: #444; font-size: 9.5pt }
.quiet { color: #444; font-size: 9.5pt; margin: .2em 0 }
.cards { display: grid; grid-template-columns: 1fr 1fr; gap: 12px }
.card { border: 1px solid #999; padding: 8px; break-inside: avoid }
svg { width: 100%; max-width: 24rem }
dt { font-weight: 600 } dd { margin: 0 0 .4em }
@media print { body { margin: 0; padding: 0; max-width: none } }
"""


def page(report: FlightReport, language: str) -> str:
    """The page; every text of the recording is escaped. `language` is `es` or `en`."""
    words = words_of(language)
    begun = datetime.fromtimestamp(report.times.started_s, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")
    what = report.identity
    known = (what.aircraft, what.board, what.firmware, what.operator, report.flight)
    facts = " · ".join(fact for fact in known if fact)
    parts = [
        f"<h1>{escape(words['title'])}</h1><p><b>{begun}</b></p><p class=quiet>{escape(facts)}</p>",
        _section(words["times"], _figures(report, TIMES, words)),
        _section(words["battery"], _figures(report, BATTERY, words)) if report.battery else "",
        _section(words["link"], _figures(report, LINK, words)),
        _section(words["alarms"], _alarms(report, words)),
        _section(words["events"], _list(_event(one, words) for one in report.events)) if report.events else "",
        _section(words["marks"], _list(f"{clock(one.at_s)}  {one.text}" for one in report.marks))
        if report.marks
        else "",
        _section(words["manoeuvres"], _manoeuvres(report, words)),
        _section(words["gains"], _gains(report, words)),
        _section(words["unknown"], _list(words["cannot"][word] for word in report.unknown)),
        _section(words["definitionsTitle"], _definitions(words)),
    ]
    return (
        f'<!doctype html><html lang="{language}"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{escape(words['title'])} {escape(report.flight)}</title><style>{_STYLE}</style></head>"
        f"<body>{''.join(parts)}</body></html>"
    )


def _section(title: str, content: str) -> str:
    return f"<section><h2>{escape(title)}</h2>{content}</section>"


def _list(lines: Any) -> str:
    return f"<ul>{''.join(f'<li>{escape(line)}</li>' for line in lines)}</ul>"


def _table(head: list[str], rows: list[list[str]]) -> str:
    top = "".join(f'<th scope="col">{escape(cell)}</th>' for cell in head)
    body = "".join(
        f'<tr><th scope="row">{escape(row[0])}</th>{"".join(f"<td>{escape(cell)}</td>" for cell in row[1:])}</tr>'
        for row in rows
    )
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _figures(report: FlightReport, rows: tuple[Row[Flown], ...], words: Words) -> str:
    earlier = report.earlier
    head = [words["figure"], words["this"], *([f"{words['otherShort']} ({earlier.flight})"] if earlier else [])]
    flights: list[Flown] = [report, *([earlier] if earlier else [])]
    return _table(head, [[words["figures"][row.name], *(row.read(one) for one in flights)] for row in rows])


def _alarms(report: FlightReport, words: Words) -> str:
    if not report.alarms:
        return f"<p>{escape(words['noAlarms'])}</p>"
    lasted = [words["untilEnd"] if one.lasted_s is None else f"{one.lasted_s:.1f} s" for one in report.alarms]
    names = [
        words["alarmNames"].get(one.name, one.name) + (f" × {one.count}" if one.count > 1 else "")
        for one in report.alarms
    ]
    return _list(
        f"{clock(one.at_s)}  {name}: {text}" for one, name, text in zip(report.alarms, names, lasted, strict=True)
    )


def _event(one: ReportEvent, words: Words) -> str:
    lasted = "" if one.until_s is None else f" ({one.until_s - one.at_s:.1f} s)"
    detail = f": {one.detail}" if one.detail else ""
    return f"{clock(one.at_s)}  {words['event'][one.kind]}{detail}{lasted}"


def _manoeuvres(report: FlightReport, words: Words) -> str:
    if report.no_manoeuvres is not None:
        return f"<p>{escape(words['why'][report.no_manoeuvres])}</p>"
    there = report.earlier.manoeuvres if report.earlier else []
    cards = []
    for one in report.manoeuvres:
        other = there[one.earlier] if one.earlier is not None else None
        both = [one, *([other] if other else [])]
        kind = words["kind"][one.kind]
        at = words["at_s"].replace("{{at}}", clock(one.at_s))
        notes = [words["cause"][one.cause]]
        if one.is_cut:
            notes.append(words["cut"])
        content = f"<p class=quiet>{escape(words['noFigures'])}</p>"
        if one.kind == "leg" or one.method != "none":
            has_model = any(flown.model is not None for flown in both)
            rows = LEG if one.kind == "leg" else ANSWER + MODEL if has_model else ANSWER
            head = [words["figure"], words["this"], *([words["otherShort"]] if other else [])]
            content = _table(head, [[words["figures"][row.name], *(row.read(flown) for flown in both)] for row in rows])
        drawn = [picture(flown, f"{kind} {at}") for flown in both]
        names = [f"<figcaption>{escape(words[name])}</figcaption>" if other else "" for name in ("this", "otherShort")]
        pictures = "".join(f"<figure>{name}{svg}</figure>" for name, svg in zip(names, drawn, strict=False))
        quiet = "".join(f"<p class=quiet>{escape(note)}</p>" for note in notes)
        cards.append(f"<div class=card><h3>{escape(f'{kind} {at}')}</h3>{pictures}{content}{quiet}</div>")
    return f"<div class=cards>{''.join(cards)}</div>"


def _gains(report: FlightReport, words: Words) -> str:
    found = "" if report.gains else f"<p>{escape(words['noGains'])}</p>"
    for gain in report.gains:
        title = f"{gain.name}: {gain.before:g} → {gain.after:g}"
        at = words["at_s"].replace("{{at}}", clock(gain.at_s))
        found += f"<h3>{escape(f'{title} {at}')}</h3>"
        if gain.loop and gain.earlier and gain.later:
            both = (gain.earlier, gain.later)
            rows = [[words["count"], *(str(effect.manoeuvres) for effect in both)]]
            rows += [
                [words["figures"][row.name], *(row.read(effect) for effect in both)] for row in gain_rows(gain.loop)
            ]
            found += _table([words["loop"][gain.loop], words["before"], words["after"]], rows)
    return found


def _definitions(words: Words) -> str:
    pairs = ((name, words["definitions"][key]) for key, name in words["figures"].items())
    return f"<dl>{''.join(f'<dt>{escape(name)}</dt><dd>{escape(meaning)}</dd>' for name, meaning in pairs)}</dl>"
