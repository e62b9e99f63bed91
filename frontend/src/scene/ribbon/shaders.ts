/** Colours in a scale; the shaders' array has a fixed length. */
export const SCALE_COLOURS = 7;

/** Shared by line and curtain: the positions and colours of a stretch's two ends. */
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

// Corner of the rectangle between the two ends: x is 1 at the far end, y is -1 or 1 at its sides.
vec2 cornerNow() { return vec2(float((gl_VertexID >> 1) & 1), float((gl_VertexID & 1) * 2 - 1)); }

vec3 colourOf(float height, vec2 rates) {
  if (u_scale.x < 0.5) { return u_plain; }
  float value = u_scale.x < 1.5 ? height : u_scale.x < 2.5 ? rates.x : rates.y;
  if (value < -1e8) { return u_unknown; }
  float place = clamp((value - u_scale.y) / (u_scale.z - u_scale.y), 0.0, 1.0) * float(${SCALE_COLOURS - 1});
  int below = min(int(place), ${SCALE_COLOURS - 2});
  return mix(u_colours[below], u_colours[below + 1], place - float(below));
}

// The flight before the first point of a piece is unknown.
bool isGap() { return toFine.w > 0.5; }
`;

/**
 * Device pixels per CSS pixel, at least one: a temporarily coarse picture has thicker lines rather than lines with
 * holes.
 */
const POINTS = `
float pointsOfPixel() { return max(czm_pixelRatio, 1.0); }
`;

/**
 * A ribbon of constant width in pixels between two points. Stretches overlap by a pixel, so that a bend has no gap;
 * round ends would have to be computed per pixel, which costs the processor as much as the rest of the line.
 * Stretches are clipped to the surroundings of the picture first: if a stretch passes beside the camera, one end is a
 * hundred thousand pixels away, and graphics processors lose such a line completely or in parts.
 */
export const LINE_VERTEX = `${COMMON}${POINTS}
uniform float u_width; // pixels of the page
uniform float u_nearer; // towards the eye: of two tracks over each other one is seen, not a mixture
out float v_across; // pixels of the picture, times w: straight on the screen
out vec3 v_colour;
flat out vec2 v_along;

const float BESIDE = 1.5; // of half the picture
const float OVERLAP = 0.5; // pixels

// Inside where all four are positive: clip coordinates within the picture and some room beside it.
vec4 inside(vec4 clip) {
  return vec4(BESIDE * clip.w - clip.x, BESIDE * clip.w + clip.x, BESIDE * clip.w - clip.y, BESIDE * clip.w + clip.y);
}

// The visible part of the way from one end to the other; none if the first is greater than the second.
vec2 seenPart(vec4 fromClip, vec4 toClip, float near) {
  vec4 a = inside(fromClip);
  vec4 b = inside(toClip);
  vec2 w = vec2(fromClip.w, toClip.w) - near;
  if (any(lessThan(max(a, b), vec4(0.0))) || max(w.x, w.y) < 0.0) { return vec2(1.0, 0.0); }
  vec4 cut = a / (a - b);
  vec4 first = mix(vec4(0.0), cut, lessThan(a, vec4(0.0)));
  vec4 last = mix(vec4(1.0), cut, lessThan(b, vec4(0.0)));
  float cutW = w.x / (w.x - w.y);
  float begin = w.x < 0.0 ? cutW : 0.0;
  float end = w.y < 0.0 ? cutW : 1.0;
  return vec2(
    max(max(max(first.x, first.y), max(first.z, first.w)), begin),
    min(min(min(last.x, last.y), min(last.z, last.w)), end)
  );
}

void main() {
  vec2 corner = cornerNow();
  vec4 from = czm_modelViewRelativeToEye * czm_translateRelativeToEye(fromCoarse.xyz, fromFine.xyz);
  vec4 to = czm_modelViewRelativeToEye * czm_translateRelativeToEye(toCoarse.xyz, toFine.xyz);
  from.xyz *= u_nearer;
  to.xyz *= u_nearer;
  vec4 fromClip = czm_projection * from;
  vec4 toClip = czm_projection * to;
  vec2 part = seenPart(fromClip, toClip, max(czm_currentFrustum.x, 0.1));
  v_across = 0.0;
  v_colour = u_plain;
  v_along = vec2(1.0, 0.0);
  if (isGap() || part.x >= part.y) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  bool isEnd = corner.x > 0.5;
  vec4 begin = mix(fromClip, toClip, part.x);
  vec4 end = mix(fromClip, toClip, part.y);
  vec2 screen = 0.5 * czm_viewport.zw;
  vec2 course = end.xy / end.w * screen - begin.xy / begin.w * screen;
  float size = length(course);
  vec2 along = size > 1e-4 ? course / size : vec2(1.0, 0.0);
  float reach = 0.5 * u_width * pointsOfPixel();
  vec2 offset = OVERLAP * (isEnd ? along : -along) + reach * corner.y * vec2(-along.y, along.x);
  gl_Position = isEnd ? end : begin;
  gl_Position.xy += offset / screen * gl_Position.w;
  v_across = corner.y * reach * gl_Position.w;
  v_along = along;
  v_colour = mix(colourOf(fromCoarse.w, fromRates), colourOf(toCoarse.w, toRates), isEnd ? part.y : part.x);
}
`;

/**
 * The line and its edge in one pass: the edge is slightly farther away than all lines, so that where lines meet or
 * cross it surrounds them together and covers none.
 */
export const LINE_FRAGMENT = `${POINTS}uniform float u_core; // pixels of the page: what is beyond is the edge
uniform vec3 u_edge;
uniform float u_opacity;
uniform float u_dash; // pixels of the page: length of a dash and of the room between two
in float v_across;
in vec3 v_colour;
flat in vec2 v_along;

const float FARTHER = 1.004;

void main() {
#ifdef DASHED
  float dash = u_dash * pointsOfPixel();
  if (mod(dot(gl_FragCoord.xy, v_along), 2.0 * dash) > dash) { discard; }
#endif
  bool isEdge = abs(v_across) * gl_FragCoord.w > 0.5 * u_core * pointsOfPixel();
  out_FragColor = vec4(isEdge ? u_edge : v_colour, u_opacity);
#ifdef LOG_DEPTH
  czm_writeLogDepth(v_depthFromNearPlusOne * (isEdge ? FARTHER : 1.0));
#endif
}
`;

/**
 * The wall between the line and sea level below it. Its depth is computed at its corners and interpolated linearly:
 * where many walls overlap, the graphics skip the hidden ones only if the shader writes no depth itself. A wall that
 * passes the camera covers everything, as something so near does.
 */
export const CURTAIN_VERTEX = `${COMMON}
out vec3 v_colour;

vec3 down(vec4 coarse, vec3 fine) {
  vec3 up = normalize((coarse.xyz + fine) * vec3(1.0, 1.0, 1.00673949674));
  return fine - up * coarse.w;
}

vec4 inView(vec4 coarse, vec3 fine) {
  return czm_modelViewRelativeToEye * czm_translateRelativeToEye(coarse.xyz, fine);
}

void main() {
  vec2 corner = cornerNow();
  bool isEnd = corner.x > 0.5;
  bool isFoot = corner.y < 0.0;
  vec4 from = inView(fromCoarse, fromFine.xyz);
  vec4 to = inView(toCoarse, toFine.xyz);
  vec4 fromFoot = inView(fromCoarse, down(fromCoarse, fromFine.xyz));
  vec4 toFoot = inView(toCoarse, down(toCoarse, toFine.xyz));
  gl_Position = czm_projection * (isEnd ? (isFoot ? toFoot : to) : (isFoot ? fromFoot : from));
  if (isGap()) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); }
#ifdef LOG_DEPTH
  else {
    czm_vertexLogDepth();
    float near = czm_currentFrustum.x;
    float nearest = -max(max(from.z, to.z), max(fromFoot.z, toFoot.z));
    float depth = nearest > near
      ? log2(gl_Position.w - near + 1.0) * czm_oneOverLog2FarDepthFromNearPlusOne
      : 1e-4;
    gl_Position.z = (2.0 * depth - 1.0) * gl_Position.w;
  }
#endif
  v_colour = colourOf(isEnd ? toCoarse.w : fromCoarse.w, isEnd ? toRates : fromRates);
}
`;

export const CURTAIN_FRAGMENT = `
uniform vec4 u_scale;
in vec3 v_colour;

void main() {
  out_FragColor = vec4(v_colour, u_scale.w);
}
`;

/** For dashed lines. */
export const DASHED_DEFINES = ["DASHED"];
/** Tells the engine that the shader already writes the right depth. */
export const CURTAIN_DEFINES = ["LOG_DEPTH_WRITE"];
