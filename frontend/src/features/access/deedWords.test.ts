import { expect, test } from "vitest";
import { createI18n } from "../../i18n/i18n";
import access from "./access.es.json";
import { deedResult, deedWords } from "./deedWords";

const control = { station: "este ordenador" };
const { t } = createI18n({ es: { ...access, control }, en: {} }, "es");

test.each([
  ["entered", "operator", "operador"],
  ["invited", "viewer, 60 min", "espectador, 60 min"],
  ["program_made", "Google Earth: viewer", "Google Earth: espectador"],
  ["people", "Ana: in, operator", "Ana: dentro, operador"],
  ["people", "Ana: ended, viewer", "Ana: terminado, espectador"],
  ["people", "Ana: forgotten", "Ana: quitado de la lista"],
  ["refused", "key of a program", "clave de un programa"],
  ["holder", "- > this computer 2", "nadie › este ordenador 2"],
  // What people are called is never taken for a word of the station.
  ["people", "in, owner: in, viewer", "in, owner: dentro, espectador"],
  ["program_made", "viewer: operator", "viewer: operador"],
  ["program_ended", "viewer", "viewer"],
  ["asked", "operator · owner", "operator · owner"],
  ["command", "POST /commands/start {}", "POST /commands/start {}"],
  ["control", 'POST /control {"client":"0a","action":"refuse","to":"0b"}', "no darlo"],
  ["control", 'POST /control {"action":"dance"}', 'POST /control {"action":"dance"}'],
])("a deed %s that says %s is read as %s", (deed, what, read) => {
  expect(deedWords(t, deed, what)).toBe(read);
});

test.each([
  ["200", "hecho"],
  ["204", "hecho"],
  ["409", "rechazado (409)"],
  ["a new word", "a new word"],
])("a result %s is read as %s", (result, read) => {
  expect(deedResult(t, result)).toBe(read);
});
