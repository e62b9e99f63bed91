import type { Waypoint } from "../../../lib/plan";
import { METRES_PER_FOOT } from "../../../lib/units";
import type { Profile } from "./useProfile";

interface Props {
  label: string;
  profile: Profile;
  waypoints: readonly Waypoint[];
  /** Altitude, feet above the sea, in the reader's unit. */
  formatAltitude: (altitude_ft: number) => string;
  selected: number | null;
  /** Of the picture in its own pixels: it is scaled to its place. */
  width?: number;
}

const FRAME = { height: 150, left: 52, bottom: 16, top: 10 };

/** A plan seen from the side: its altitude over the ground, where that is known; elsewhere a broken line at the bottom. */
export function ProfilePicture(props: Props) {
  const { label, profile, waypoints, formatAltitude, selected, width = 600 } = props;
  const size = { ...FRAME, width };
  const { places, heights } = profile;
  const total_m = places.at(-1)?.along_m ?? 0;
  const ground_ft = places.map((_, index) => {
    const height_m = heights?.[index] ?? null;
    return height_m === null ? null : height_m / METRES_PER_FOOT;
  });
  const known = ground_ft.filter((height) => height !== null);
  const top_ft = 1.1 * Math.max(100, ...places.map(({ altitude_ft }) => altitude_ft), ...known);
  const bottom_ft = Math.min(0, ...known);
  const x = (along_m: number): number =>
    size.left + (total_m === 0 ? 0.5 : along_m / total_m) * (size.width - size.left - 8);
  const y = (altitude_ft: number): number =>
    size.height -
    size.bottom -
    ((altitude_ft - bottom_ft) / (top_ft - bottom_ft)) * (size.height - size.bottom - size.top);
  const floor = size.height - size.bottom;
  const marks = [bottom_ft, (bottom_ft + top_ft) / 2, top_ft];
  return (
    <svg
      className="map-profile-picture"
      viewBox={`0 0 ${size.width} ${size.height}`}
      role="img"
      aria-label={label}
    >
      {marks.map((altitude_ft) => (
        <g key={altitude_ft}>
          <line
            className="map-profile-grid"
            x1={size.left}
            x2={size.width}
            y1={y(altitude_ft)}
            y2={y(altitude_ft)}
          />
          <text x={size.left - 4} y={y(altitude_ft) + 4} textAnchor="end">
            {formatAltitude(altitude_ft)}
          </text>
        </g>
      ))}
      {places.slice(1).map((to, index) => {
        const from = places[index] ?? to;
        const [before, after] = [ground_ft[index] ?? null, ground_ft[index + 1] ?? null];
        return before === null || after === null ? (
          <line
            key={to.along_m}
            className="map-profile-unknown"
            x1={x(from.along_m)}
            x2={x(to.along_m)}
            y1={floor}
            y2={floor}
          />
        ) : (
          <polygon
            key={to.along_m}
            className="map-profile-ground"
            points={`${x(from.along_m)},${floor} ${x(from.along_m)},${y(before)} ${x(to.along_m)},${y(after)} ${x(to.along_m)},${floor}`}
          />
        );
      })}
      <polyline
        className="map-profile-plan"
        points={places.map(({ along_m, altitude_ft }) => `${x(along_m)},${y(altitude_ft)}`).join(" ")}
      />
      {rowPlaces(profile, waypoints).map(({ along_m, altitude_ft, row }) => (
        <g key={row} className="map-profile-waypoint" data-selected={row === selected}>
          <circle cx={x(along_m)} cy={y(altitude_ft)} r={row === selected ? 5 : 3.5} />
          <text x={x(along_m)} y={size.height - 3} textAnchor="middle">
            {row + 1}
          </text>
        </g>
      ))}
    </svg>
  );
}

/** The last place of each leg is its waypoint. */
function rowPlaces({ places }: Profile, waypoints: readonly Waypoint[]): Profile["places"] {
  return waypoints.flatMap((_, row) => places.findLast((place) => place.row === row) ?? []);
}
