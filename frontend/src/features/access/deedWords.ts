import type { TFunction } from "i18next";
import { ROLES } from "../../store/admission";

/** What the station writes in a deed's `what`, in the reader's words. Names of people come first and may be anything. */
export function deedWords(t: TFunction, deed: string, what: string): string {
  switch (deed) {
    case "holder":
      return holders(t, what);
    case "control":
      return controlChange(t, what);
    case "entered":
    case "invited":
      return what.replace(/^\w+/, (word) => role(t, word));
    case "program_made":
      return what.replace(/\w+$/, (word) => role(t, word));
    case "people":
      return what
        .replace(/(?<=: (?:in|ended|waiting), )\w+$/, (word) => role(t, word))
        .replace(/(?<=: )(?:in|ended|waiting|forgotten)(?=$|, [^:]+$)/, (word) => state(t, word));
    case "refused":
      return what === "key of a program" ? t("access.keyOfProgram") : what;
    default:
      return what;
  }
}

/** Who had control and who has it now, as the station writes it: `Ana · tablet > this computer`. */
function holders(t: TFunction, names: string): string {
  return names
    .split(" > ")
    .map((one) =>
      one === "-" ? t("access.holderNobody") : one.replace(/^this computer\b/, t("control.station")),
    )
    .join(" › ");
}

const CHANGES = ["take", "release", "ask", "withdraw", "grant", "refuse", "hand_over"] as const;

/** `POST /control {"action":"ask",...}`; the line after it says who has control then. */
function controlChange(t: TFunction, what: string): string {
  const action = /"action": ?"(\w+)"/.exec(what)?.[1];
  const known = CHANGES.find((one) => one === action);
  return known === undefined ? what : t(`access.deedControl.${known}`);
}

/** What came of a deed: a request's status as the log has it, or the station's own word. */
export function deedResult(t: TFunction, result: string): string {
  if (/^2\d\d$/.test(result)) {
    return t("deedResult.done");
  }
  return /^[45]\d\d$/.test(result) ? t("access.deedRefused", { status: result }) : result;
}

const STATES = ["in", "ended", "waiting", "forgotten"] as const;

function state(t: TFunction, word: string): string {
  const known = STATES.find((one) => one === word);
  return known === undefined ? word : t(`access.deedState.${known}`);
}

function role(t: TFunction, word: string): string {
  const known = ROLES.find((one) => one === word);
  return known === undefined ? word : t(`role.${known}`);
}
