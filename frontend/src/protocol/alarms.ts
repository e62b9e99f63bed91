import { type Checked, dictionary, isFlag, isNumber, isText, list, oneOf, shape } from "../lib/check";
import type { components } from "./api.gen";

const isLevel = oneOf("warning", "critical");
/** Whatever stands in the sentence; what is neither text nor number is not shown. */
const isParams = dictionary((_value): _value is unknown => true);

/** The gateway's list of alarms. The active ones come with the status and are not read from here. */
export const isAlarmBook = shape({
  past: list(
    shape({
      id: isText,
      level: isLevel,
      text: isText,
      params: isParams,
      since_s: isNumber,
      until_s: isNumber,
      acknowledged: isFlag,
    }),
  ),
});

/** The limits at which alarms come, each with its range and what it is when nobody has chosen. */
export const isThresholds = shape({
  thresholds: list(
    shape({
      name: isText,
      value: isNumber,
      default: isNumber,
      minimum: isNumber,
      maximum: isNumber,
      unit: isText,
    }),
  ),
});

export type AlarmBookAnswer = Checked<typeof isAlarmBook>;
export type ThresholdAnswer = Checked<typeof isThresholds>;

type Described = components["schemas"];
/** Do not compile when the gateway describes its answers otherwise than they are checked here. */
export const alarmBookIsAsDescribed: Described["AlarmBook"] extends AlarmBookAnswer ? true : false = true;
export const thresholdsAreAsDescribed: Described["ThresholdList"] extends ThresholdAnswer ? true : false =
  true;
