// Shaders: the surface, what is picked under the pointer, and the dots.
import { BackSide, Color, DoubleSide, FrontSide, GLSL3, NoBlending, ShaderMaterial } from 'three';
import { kLatticeWidth, kTextureWidth, kUnlabelled, ramp_texture } from './colours.js';

// Where the surface's colour comes from: the region's entry in a texture, a value of each point or face, or nothing.
export const kSources = { regions: 0, distance: 1, quality: 2, angle: 2, plain: 3, surface_distance: 4 };

const kSurfaceVertex = /* glsl */ `
attribute float code;
attribute float distance;
attribute float value;
attribute float share;
attribute float open;
attribute vec2 lattice;
attribute vec2 chart;
flat varying float v_code;
flat varying vec2 v_lattice;
varying float v_distance;
varying float v_value;
varying float v_share;
varying float v_open;
varying vec2 v_bary;
varying vec2 v_chart;
varying vec3 v_normal;
varying vec3 v_view;
void main() {
  v_chart = chart;
  v_code = code;
  v_distance = distance;
  v_value = value;
  v_share = share;
  v_open = open;
  v_lattice = lattice;
  int corner = gl_VertexID % 3;
  v_bary = vec2(corner == 0, corner == 2);
  v_normal = normalMatrix * normal;
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  v_view = view.xyz;
  gl_Position = projectionMatrix * view;
}`;

const kSurfaceFragment = /* glsl */ `
uniform sampler2D fills, ramp;
uniform highp sampler2D lattices;
uniform vec3 plain;
uniform int source;
uniform bool show_lines, smooth_normals, shaded;
uniform float largest_distance, line_spacing, pinned, checks;
flat varying float v_code;
flat varying vec2 v_lattice;
varying float v_distance;
varying float v_value;
varying float v_share;
varying float v_open;
varying vec2 v_bary;
varying vec2 v_chart;
varying vec3 v_normal;
varying vec3 v_view;

vec3 fill_of(float code) {
  int i = int(code + 0.5);
  return texelFetch(fills, ivec2(i % ${kTextureWidth}, i / ${kTextureWidth}), 0).rgb;
}

vec3 ramp_at(float t) {
  return texture2D(ramp, vec2((clamp(t, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

float in_lattice(int row, int j) {
  int i = int(v_lattice.x + 0.5) + row * (2 * int(v_lattice.y + 0.5) + 3 - row) / 2 + j;
  return texelFetch(lattices, ivec2(i % ${kLatticeWidth}, i / ${kLatticeWidth}), 0).r;
}

// As locate_in_lattice of surface_distance.js.
float lattice_share() {
  float k = v_lattice.y;
  vec2 p = max(v_bary * k, 0.0);
  int i = int(min(floor(p.x), k - 1.0)), j = int(min(floor(p.y), k - 1.0 - float(i)));
  float u = p.x - float(i), v = p.y - float(j);
  if (u + v > 1.0 && float(i + j) < k - 1.0)
    return (u + v - 1.0) * in_lattice(i + 1, j + 1) + (1.0 - u) * in_lattice(i, j + 1) + (1.0 - v) * in_lattice(i + 1, j);
  return (1.0 - u - v) * in_lattice(i, j) + u * in_lattice(i + 1, j) + v * in_lattice(i, j + 1);
}

vec3 base_colour(bool reached) {
  if (source == ${kSources.regions}) return fill_of(v_code);
  if (source == ${kSources.quality}) return ramp_at(v_value);
  if (source == ${kSources.surface_distance}) return ramp_at(v_lattice.y > 1.0 ? lattice_share() : v_share);
  if (source == ${kSources.distance}) return reached ? ramp_at(v_distance / largest_distance) : fill_of(0.0);
  return plain;
}

// The share of dark squares in a pixel of a checkerboard, by the integral along each side.
float dark_share(vec2 p) {
  vec2 width = max(fwidth(p), 1e-3), from = (p - 0.5 * width) / 2.0, to = (p + 0.5 * width) / 2.0;
  vec2 balance = 2.0 * (abs(fract(from) - 0.5) - abs(fract(to) - 0.5)) / width;
  return 0.5 - 0.5 * balance.x * balance.y;
}

// Light from the camera's upper left and from the sky, of which the point sees the share open.
vec3 light(vec3 base, vec3 n, vec3 eye, float open) {
  vec3 key = normalize(vec3(-0.45, 0.7, 0.7)), fill = normalize(vec3(0.8, -0.05, 0.5));
  float shade = pow(open, 1.8), direct = mix(0.55, 1.0, shade);
  vec3 sky = mix(vec3(0.50, 0.47, 0.46), vec3(0.66, 0.67, 0.69), 0.5 + 0.5 * n.y) * mix(0.3, 1.0, shade);
  float diffuse = 0.52 * direct * max(dot(n, key), 0.0) + 0.14 * max(dot(n, fill), 0.0);
  float gloss = pow(max(dot(n, normalize(key + eye)), 0.0), 28.0);
  return base * (sky + diffuse) + vec3(0.045 * direct * gloss);
}

void main() {
  vec3 eye = normalize(-v_view);
  vec3 flat_normal = normalize(cross(dFdx(v_view), dFdy(v_view)));
  vec3 n = smooth_normals ? normalize(v_normal) * kSide : flat_normal;
  bool reached = v_distance >= 0.0;
  vec3 base = base_colour(reached);
  if (v_code == pinned) base = mix(base, vec3(1.0), 0.45);
  if (checks > 0.0) base *= 1.0 - 0.3 * dark_share(v_chart * checks);
  if (show_lines && reached) {
    float step = v_distance / line_spacing;
    float width = max(fwidth(step), 1e-6);
    float gap = abs(fract(step - 0.5) - 0.5) / width;
    base *= 1.0 - 0.45 * (1.0 - smoothstep(0.4, 1.3, gap)) * (1.0 - smoothstep(0.15, 0.5, width));
  }
  if (kSide < 0.0) base *= 0.55;
  gl_FragColor = vec4(light(base, n, eye, shaded ? v_open : 1.0), 1.0);
  #include <colorspace_fragment>
}`;

// One material for the outside of the surface and a darker one for its inside; they share their uniforms. The inside is
// drawn slightly farther from the eye. Otherwise it would be visible at silhouettes, through the rim of the outside. In
// haste one material draws both at once, where both can be seen.
export function make_surface_materials() {
  const common = { vertexShader: kSurfaceVertex, fragmentShader: kSurfaceFragment };
  const outside = new ShaderMaterial({
    ...common,
    side: FrontSide,
    defines: { kSide: '1.0' },
    uniforms: make_uniforms(),
  });
  const inside = new ShaderMaterial({
    ...common,
    side: BackSide,
    defines: { kSide: '-1.0' },
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 2,
  });
  const both = new ShaderMaterial({ ...common, side: DoubleSide, defines: { kSide: '(gl_FrontFacing ? 1.0 : -1.0)' } });
  inside.uniforms = both.uniforms = outside.uniforms;
  return { outside, inside, both };
}

function make_uniforms() {
  return {
    fills: { value: null },
    ramp: { value: ramp_texture() },
    lattices: { value: null },
    plain: { value: kUnlabelled.clone() },
    source: { value: kSources.regions },
    show_lines: { value: false },
    smooth_normals: { value: true },
    shaded: { value: false },
    largest_distance: { value: 1 },
    line_spacing: { value: 1 },
    pinned: { value: -1 },
    checks: { value: 0 },
  };
}

// The other surface: clear where it is seen from the front, so that colours below show, and visible at its outline.
export function make_overlay_material() {
  return new ShaderMaterial({
    vertexShader: /* glsl */ `
      varying vec3 v_normal;
      varying vec3 v_view;
      void main() {
        v_normal = normalMatrix * normal;
        vec4 view = modelViewMatrix * vec4(position, 1.0);
        v_view = view.xyz;
        gl_Position = projectionMatrix * view;
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      varying vec3 v_normal;
      varying vec3 v_view;
      void main() {
        float facing = clamp(dot(normalize(v_normal), normalize(-v_view)), 0.0, 1.0);
        gl_FragColor = vec4(colour, 0.08 + 0.5 * pow(1.0 - facing, 2.0));
        #include <colorspace_fragment>
      }`,
    transparent: true,
    depthWrite: false,
    polygonOffset: true,  // where the surfaces coincide, this one is hidden as a whole
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 8,
    uniforms: { colour: { value: new Color() } },
  });
}

// Writes (the depth's bits, code, the distance's bits, the triangle): integers, because every WebGL 2 device can draw into these.
export function make_pick_material() {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    side: DoubleSide,
    blending: NoBlending,
    vertexShader: /* glsl */ `
      in float code;
      in float distance;
      flat out float v_code;
      flat out int v_triangle;
      out float v_distance;
      out float v_depth;
      void main() {
        v_triangle = gl_VertexID / 3;
        v_code = code;
        v_distance = distance;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        v_depth = gl_Position.w;
      }`,
    fragmentShader: /* glsl */ `
      flat in float v_code;
      flat in int v_triangle;
      in float v_distance;
      in float v_depth;
      layout(location = 0) out highp uvec4 picked;
      void main() { picked = uvec4(floatBitsToUint(v_depth), uint(v_code + 0.5), floatBitsToUint(v_distance), uint(v_triangle)); }`,
  });
}

// How much nearer to the eye marks are drawn, in pixels. Without it, a sloping surface would hide a part of each mark
// on it. A mark of radius r pixels is visible as a whole up to a slope of pull / r. Marks farther behind the surface
// stay hidden. A polygon offset would grow with the slope and show marks of the far side at silhouettes.
const kPull = /* glsl */ `
uniform float viewport_height;
void pull(float pixels) {
  float z = gl_Position.w * (2.0 * pixels / (projectionMatrix[1][1] * viewport_height) - 1.0);
  gl_Position.z = (projectionMatrix[2][2] * z + projectionMatrix[3][2]) / -z * gl_Position.w;
}`;

// Segments `width` pixels wide with round ends: each is a rectangle round both of its ends, from four copies of them.
// Instances of one rectangle would take four times as long in software, which draws each instance by itself.
export function make_line_material(width) {
  return new ShaderMaterial({
    vertexShader: /* glsl */ `
      ${kPull}
      attribute vec3 end;
      uniform float width;
      flat varying float v_length;
      varying vec2 v_place;  // along and across, in half widths
      void main() {
        mat4 camera = projectionMatrix * modelViewMatrix;
        vec4 a = camera * vec4(position, 1.0), b = camera * vec4(end, 1.0);
        float least = 1e-3 * max(a.w, b.w);
        if (a.w < least) a = mix(a, b, (least - a.w) / (b.w - a.w));
        if (b.w < least) b = mix(b, a, (least - b.w) / (a.w - b.w));
        vec2 radius = width / viewport_height * vec2(projectionMatrix[0][0] / projectionMatrix[1][1], 1.0);
        vec2 along = (b.xy / b.w - a.xy / a.w) / radius;
        v_length = length(along);
        along = v_length > 1e-4 ? along / v_length : vec2(1.0, 0.0);
        bool last = gl_VertexID % 4 > 1;
        float way = last ? 1.0 : -1.0, side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
        v_place = vec2(last ? v_length + 1.0 : -1.0, side);
        gl_Position = last ? b : a;
        gl_Position.xy += (along * way + vec2(-along.y, along.x) * side) * radius * gl_Position.w;
        pull(3.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      flat varying float v_length;
      varying vec2 v_place;
      void main() {
        float beyond = max(max(-v_place.x, v_place.x - v_length), 0.0);
        if (beyond * beyond + v_place.y * v_place.y > 1.0) discard;
        gl_FragColor = vec4(colour, 1.0);
        #include <colorspace_fragment>
      }`,
    side: DoubleSide,
    uniforms: { colour: { value: new Color() }, width: { value: width }, viewport_height: { value: 1 } },
  });
}

export function make_wire_material() {
  return new ShaderMaterial({
    vertexShader: /* glsl */ `
      ${kPull}
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        pull(1.5);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      void main() {
        gl_FragColor = vec4(colour, 0.35);
        #include <colorspace_fragment>
      }`,
    transparent: true,
    depthWrite: false,
    uniforms: { colour: { value: new Color() }, viewport_height: { value: 1 } },
  });
}

// Round dots that grow with the picture. Their diameter is `size` in the page's coordinates, but at least `least` and at
// most `most` pixels. They fade where generators are less than 36 pixels apart, and are gone at 20.
export function make_dot_material(least, most) {
  return new ShaderMaterial({
    vertexShader: /* glsl */ `
      ${kPull}
      uniform float size, least, most, spacing, pixel_ratio;
      varying float v_diameter, v_fade;
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        float scale = 0.5 * projectionMatrix[1][1] * viewport_height / gl_Position.w;
        v_diameter = clamp(size * scale, least, most);
        v_fade = smoothstep(20.0, 36.0, spacing * scale);
        pull(v_diameter);
        gl_PointSize = (v_diameter + 1.0) * pixel_ratio;
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 fill, ring;
      varying float v_diameter, v_fade;
      void main() {
        float r = length(gl_PointCoord - 0.5) * (v_diameter + 1.0);
        float inside = v_fade * (1.0 - smoothstep(0.5 * v_diameter - 0.5, 0.5 * v_diameter + 0.5, r));
        if (inside < 0.02) discard;
        float rim = 0.17 * v_diameter;
        float core = 1.0 - smoothstep(0.5 * v_diameter - rim - 0.5, 0.5 * v_diameter - rim + 0.5, r);
        gl_FragColor = vec4(mix(ring, fill, core), inside);
        #include <colorspace_fragment>
      }`,
    transparent: true,
    uniforms: {
      size: { value: 0.03 },
      spacing: { value: 1 },
      least: { value: least },
      most: { value: most },
      pixel_ratio: { value: 1 },
      viewport_height: { value: 1 },
      fill: { value: new Color() },
      ring: { value: new Color() },
    },
  });
}
