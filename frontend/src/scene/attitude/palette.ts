/** Colours of a picture as the theme has them, `#rrggbb`. */
export interface Palette {
  readonly background: string;
  readonly text: string;
  readonly muted: string;
  readonly line: string;
  readonly body: string;
  readonly belly: string;
  readonly glass: string;
  readonly left: string;
  readonly right: string;
  readonly grey: string;
  readonly axisX: string;
  readonly axisY: string;
  readonly axisZ: string;
  readonly acceleration: string;
  readonly field: string;
  readonly warning: string;
  readonly good: string;
}
