import type { Thumbnail } from "../../protocol/guards.gen";
import "./flight-picture.css";

/** Sides of the two pictures, in the units of the drawing. */
const TRACK = 40;
const [WIDE, HIGH] = [64, 40];
const EDGE = 3;

/** The flown track from above and the altitude over time, side by side. Its numbers are given as text beside it. */
export function FlightPicture({ thumbnail }: { readonly thumbnail: Thumbnail | null }) {
  return (
    <span className="flights-picture" aria-hidden="true">
      <svg aria-hidden="true" viewBox={`0 0 ${TRACK} ${TRACK}`} className="flights-track">
        {thumbnail !== null && <path d={trackPath(thumbnail.track)} />}
      </svg>
      <svg
        aria-hidden="true"
        viewBox={`0 0 ${WIDE} ${HIGH}`}
        className="flights-altitude"
        preserveAspectRatio="none"
      >
        {thumbnail !== null && <path d={altitudePath(thumbnail.altitude)} />}
      </svg>
    </span>
  );
}

/** North is up: pictures count from the top. */
function trackPath(track: readonly (readonly number[])[]): string {
  const side = TRACK - 2 * EDGE;
  const points = track.map(([x = 0, y = 0]) => place(EDGE + x * side, EDGE + (1 - y) * side));
  return points.length === 0 ? "" : `M${points.join("L")}`;
}

/** A gap in the altitude is a gap in the line. */
export function altitudePath(altitude: readonly (number | null)[]): string {
  const step = (WIDE - 2 * EDGE) / Math.max(1, altitude.length - 1);
  let isDown = false;
  let path = "";
  altitude.forEach((height, index) => {
    if (height === null) {
      isDown = false;
      return;
    }
    path += `${isDown ? "L" : "M"}${place(EDGE + index * step, HIGH - EDGE - height * (HIGH - 2 * EDGE))}`;
    isDown = true;
  });
  return path;
}

function place(x: number, y: number): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
