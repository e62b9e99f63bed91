/** Colours in a scale; the shaders' array has a fixed length. */
export const SCALE_COLOURS = 7;

/** What line and curtain share: where the two ends of one stretch lie, and which colour they have. */
const COMMON = `
in vec4 fromCoarse;
in vec4 fromFine;
in vec2 fromRates;
in vec4 toCoarse;
in vec4 toFine;
in vec2 toRates;

uniform vec4 u_scale; // by what (0 none, 1 height, 2 speed, 3 climb), least, most, how much light comes through
uniform vec3 u_plain;
uniform vec3 u_unknown;
uniform vec3 u_colours[${SCALE_COLOURS}];

// Of a rectangle between the two ends: 1 at the far one, -1 and 1 to its sides.
vec2 cornerNow() { return vec2(float((gl_VertexID >> 1) & 1), float((gl_VertexID & 1) * 2 - 1)); }

vec3 colourOf(float height, vec2 rates) {
  if (u_scale.x < 0.5) { return u_plain; }
  float value = u_scale.x < 1.5 ? height : u_scale.x < 2.5 ? rates.x : rates.y;
  if (value < -1e8) { return u_unknown; }
  float place = clamp((value - u_scale.y) / (u_scale.z - u_scale.y), 0.0, 1.0) * float(${SCALE_COLOURS - 1});
  int below = min(int(place), ${SCALE_COLOURS - 2});
  return mix(u_colours[below], u_colours[below + 1], place - float(below));
}

// Nobody knows what was flown before the first point of a piece.
bool isGap() { return toFine.w > 0.5; }
`;

/** A ribbon of so many pixels between two points, with round ends, so that stretches join without a notch. */
export const LINE_VERTEX = `${COMMON}
uniform float u_width;
uniform float u_nearer; // towards the eye: of two tracks over each other one is seen, not a mixture
out vec3 v_place; // along and across in pixels, times w, and w: straight on the screen
out float v_length;
out vec3 v_colour;

void main() {
  vec2 corner = cornerNow();
  vec4 from = czm_modelViewRelativeToEye * czm_translateRelativeToEye(fromCoarse.xyz, fromFine.xyz);
  vec4 to = czm_modelViewRelativeToEye * czm_translateRelativeToEye(toCoarse.xyz, toFine.xyz);
  from.xyz *= u_nearer;
  to.xyz *= u_nearer;
  float near = -max(czm_currentFrustum.x, 0.1);
  v_place = vec3(0.0, 0.0, 1.0);
  v_length = 0.0;
  v_colour = u_plain;
  if (isGap() || (from.z > near && to.z > near)) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec3 fromColour = colourOf(fromCoarse.w, fromRates);
  vec3 toColour = colourOf(toCoarse.w, toRates);
  // An end behind the eye would be turned over by the projection.
  if (from.z > near) {
    float cut = (near - from.z) / (to.z - from.z);
    from = mix(from, to, cut);
    fromColour = mix(fromColour, toColour, cut);
  } else if (to.z > near) {
    float cut = (near - to.z) / (from.z - to.z);
    to = mix(to, from, cut);
    toColour = mix(toColour, fromColour, cut);
  }
  vec4 fromClip = czm_projection * from;
  vec4 toClip = czm_projection * to;
  vec2 screen = 0.5 * czm_viewport.zw;
  vec2 course = toClip.xy / toClip.w * screen - fromClip.xy / fromClip.w * screen;
  float size = length(course);
  vec2 along = size > 1e-4 ? course / size : vec2(1.0, 0.0);
  float reach = 0.5 * u_width + 0.5;
  bool isEnd = corner.x > 0.5;
  vec2 offset = reach * ((isEnd ? along : -along) + corner.y * vec2(-along.y, along.x));
  gl_Position = isEnd ? toClip : fromClip;
  gl_Position.xy += offset / screen * gl_Position.w;
  v_place = vec3(isEnd ? size + reach : -reach, corner.y * reach, 1.0) * gl_Position.w;
  v_length = size;
  v_colour = isEnd ? toColour : fromColour;
}
`;

export const LINE_FRAGMENT = `
uniform float u_width;
uniform vec4 u_casing; // colour, and 1 where the casing is drawn
in vec3 v_place;
in float v_length;
in vec3 v_colour;

void main() {
  vec2 place = v_place.xy / v_place.z;
  float beyond = max(-place.x, place.x - v_length);
  if (length(vec2(max(beyond, 0.0), place.y)) > 0.5 * u_width) {
    discard;
  }
  out_FragColor = vec4(mix(v_colour, u_casing.rgb, u_casing.a), 1.0);
}
`;

/** The wall between the line and the sea's level below it. */
export const CURTAIN_VERTEX = `${COMMON}
out vec3 v_colour;

vec3 down(vec4 coarse, vec3 fine) {
  vec3 up = normalize((coarse.xyz + fine) * vec3(1.0, 1.0, 1.00673949674));
  return fine - up * coarse.w;
}

void main() {
  vec2 corner = cornerNow();
  bool isEnd = corner.x > 0.5;
  vec4 coarse = isEnd ? toCoarse : fromCoarse;
  vec3 fine = isEnd ? toFine.xyz : fromFine.xyz;
  if (corner.y < 0.0) { fine = down(coarse, fine); }
  gl_Position = isGap()
    ? vec4(0.0, 0.0, 2.0, 1.0)
    : czm_modelViewProjectionRelativeToEye * czm_translateRelativeToEye(coarse.xyz, fine);
  v_colour = colourOf(coarse.w, isEnd ? toRates : fromRates);
}
`;

export const CURTAIN_FRAGMENT = `
uniform vec4 u_scale;
in vec3 v_colour;

void main() {
  out_FragColor = vec4(v_colour, u_scale.w);
}
`;
