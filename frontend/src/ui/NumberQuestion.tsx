import type { TwoReadings } from "./number";
import { useWords } from "./words";

interface Props {
  readings: TwoReadings;
  unit?: string | undefined;
  /** The number that was meant. */
  onChoose: (value: number) => void;
}

/** Which of two numbers was typed: "1.000" is a thousand for one person and one for another. */
export function NumberQuestion({ readings, unit, onChoose }: Props) {
  const words = useWords();
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset would need a line of its own for its name
    <span className="ui-number-question" role="group" aria-label={words.whichNumber}>
      {[readings.thousand, readings.one].map((text) => (
        <button
          key={text}
          type="button"
          className="ui-number-reading"
          // The press must not take the focus: leaving the field is another answer.
          onMouseDown={(event) => event.preventDefault()}
          onClick={() => onChoose(Number(text))}
        >
          {unit === undefined ? text : `${text} ${unit}`}
        </button>
      ))}
    </span>
  );
}
