// One line as two triangles in window space: six vertices per line, end points fetched by index. Widths in pixels.
#version 330 core

uniform samplerBuffer positions;  // x, y, z of each particle in three texels, m
uniform usamplerBuffer lines;     // the two particles of each line
uniform mat4 view;
uniform mat4 projection;
uniform vec2 pixels;              // size of the window
uniform float focal;              // pixels per metre at a distance of one metre
uniform float nearest;            // distance at which lines are cut, m
uniform float width;              // pixels, at the distance `middle`
uniform float spacing;            // m between neighbouring lines of the mesh; 0: not a mesh, never thinned
uniform int columns;              // of the mesh
uniform int particles;            // of the mesh
uniform float sideBySide;         // how many lines of the mesh lie beside each other where it is narrowest
uniform float middle;             // distance to the middle of the cloth, m
uniform bool onSurface;           // lines that are too dense to be told apart leave the surface as it is
uniform float sideways;           // pixels to draw the line beside where it lies (two families may lie in one line)
uniform int colouring;            // 0: one colour, 1: by the numbers of the particles, 2: by the lines' strain
uniform samplerBuffer values;     // a number of each particle
uniform float restLength;         // m, of every line
uniform vec2 range;               // the numbers at both ends of the colours
uniform vec2 depths;              // of the nearest and the farthest part of the cloth, m

noperspective out float across;   // pixels from the line's middle
noperspective out float halfWidth;
noperspective out float opacity;
noperspective out float tone;     // above 0: part of an even tone, which hides nothing
out float alongRamp;              // 0 at the first of the colours, 1 at the last
out float farness;                // 0 at the cloth's nearest part, 1 at the farthest

const vec2 kCorners[6] = vec2[6](vec2(0, -1), vec2(1, -1), vec2(0, 1), vec2(0, 1), vec2(1, -1), vec2(1, 1));
const float kFringe = 0.75;       // pixels on each side that hold the soft edge
const float kDensest = 0.3;       // share of the space between lines that a line may fill
const float kThinnest = 1.0;      // pixels; below that a line grows fainter instead
const float kSoftWidth = 2.0;     // pixels; such lines are as dark wherever they lie between pixels
// Pixels from line to line: nearer ones become an even tone, then come soft lines, then sharp ones.
const float kFlat = 2.6, kSoftFrom = 4.0, kSoftTo = 5.0, kApart = 8.0;
const float kGone = 2.0;          // likewise, on a surface: nearer ones are not drawn at all

vec3 viewPosition(uint particle) {
  int i = 3 * int(particle);
  vec3 p = vec3(texelFetch(positions, i).r, texelFetch(positions, i + 1).r, texelFetch(positions, i + 2).r);
  return (view * vec4(p, 1)).xyz;
}

// The particle that lies beside `end` as seen from the line from `low` to `high`; -1: there is none.
int besideOf(int end, int low, int high) {
  if (low % columns + high - low < columns) {  // along a row: in the next row, else in the one before
    return high + columns < particles ? end + columns : low >= columns ? end - columns : -1;
  }
  int left = min(low % columns, high % columns), right = max(low % columns, high % columns);
  return right + 1 < columns ? end + 1 : left > 0 ? end - 1 : -1;
}

vec2 windowPosition(vec4 clip) { return clip.xy / clip.w * pixels / 2; }

void main() {
  vec2 corner = kCorners[gl_VertexID % 6];
  uvec2 ends = texelFetch(lines, gl_VertexID / 6).rg;
  vec3 a = viewPosition(ends.x), b = viewPosition(ends.y);
  across = halfWidth = opacity = tone = farness = alongRamp = 0.0;
  gl_Position = vec4(2, 2, 2, 1);  // all six vertices in one point outside: nothing is drawn
  if (colouring == 1) alongRamp = texelFetch(values, int(corner.x < 0.5 ? ends.x : ends.y)).r;
  if (colouring == 2) alongRamp = length(a - b) / restLength - 1;
  alongRamp = (alongRamp - range.x) / max(range.y - range.x, 1e-30);
  // Written so that positions that are not numbers are dropped as well.
  if (!(a.z <= -nearest || b.z <= -nearest)) return;
  if (!(a.z <= -nearest)) a = mix(b, a, (-nearest - b.z) / (a.z - b.z));
  if (!(b.z <= -nearest)) b = mix(a, b, (-nearest - a.z) / (b.z - a.z));

  vec4 clipA = projection * vec4(a, 1), clipB = projection * vec4(b, 1);
  vec2 along = windowPosition(clipB) - windowPosition(clipA);
  float reach = length(along);
  along = reach > 1e-4 ? along / reach : vec2(1, 0);

  float depth = corner.x < 0.5 ? -a.z : -b.z;
  float wanted = width * clamp(middle / depth, 0.8, 1.5);  // nearer is a little wider
  // Dense lines are thinned, but all of them together are still to be seen as one line.
  if (spacing > 0.0) wanted = min(wanted, max(kDensest * spacing * focal / depth, width / sideBySide));
  float drawn = max(wanted, kThinnest);
  int low = int(min(ends.x, ends.y)), high = int(max(ends.x, ends.y));
  int beside = spacing > 0.0 ? besideOf(corner.x < 0.5 ? int(ends.x) : int(ends.y), low, high) : -1;
  float alone = drawn;  // the width of what one line has for itself
  float fading = 1.0;
  if (beside >= 0) {
    vec4 clipC = projection * vec4(viewPosition(uint(beside)), 1);
    vec2 away = windowPosition(clipC) - windowPosition(corner.x < 0.5 ? clipA : clipB);
    float apart = max(abs(away.x * along.y - away.y * along.x), kThinnest / 20);
    if (onSurface) fading = smoothstep(kGone, kSoftFrom, apart);
    // Lines whose width is a whole multiple of their distance cover all pixels alike, wherever they lie between them.
    float even = apart * ceil(kSoftWidth / apart);
    if (apart < kApart && clipC.w > 0.0) {
      float soft = mix(kSoftWidth, drawn, smoothstep(kSoftTo, kApart, apart));
      drawn = max(drawn, mix(even, soft, smoothstep(kFlat, kSoftFrom, apart)));
      alone = min(apart, drawn);
    }
  }
  tone = drawn > max(wanted, kThinnest) ? 1.0 : 0.0;
  // Where lines lie over each other, all of them together are as dark as if each had its own place.
  opacity = fading * (1.0 - pow(1.0 - min(wanted / alone, 1.0), alone / drawn));
  halfWidth = drawn / 2;
  across = corner.y * (halfWidth + kFringe);
  farness = clamp((depth - depths.x) / (depths.y - depths.x), 0.0, 1.0);

  vec4 clip = corner.x < 0.5 ? clipA : clipB;
  float aside = across + sideways * wanted / width;
  clip.xy += vec2(-along.y, along.x) * aside * 2 / pixels * clip.w;
  gl_Position = clip;
}
