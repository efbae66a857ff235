// The light of the lamps, for every shader of something solid. It wraps around (half of Lambert's cosine, and a half, both
// squared), so that no side is without shape.

uniform int lamps;
uniform vec4 lampFrom[4];    // the unit vector towards the lamp, and 0; or its place, m, and 1
uniform vec3 lampColour[4];

vec3 lampLight(vec3 point, vec3 normal, float through) {
  vec3 light = vec3(0);
  for (int k = 0; k < lamps; ++k) {
    vec3 towards = normalize(lampFrom[k].xyz - lampFrom[k].w * point);
    float cosine = dot(normal, towards);
    float wrapped = 0.5 + 0.5 * cosine;
    light += lampColour[k] * (wrapped * wrapped + through * max(-cosine, 0.0));
  }
  return min(light, vec3(1.15));
}
