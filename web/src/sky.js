// How much of the sky each point sees: soft shade in hollows, and the shadow on the ground.
//
// The graphics card draws the surface's depth from many directions into the tiles of one texture. Then it looks up each
// point in all tiles. The result does not depend on the camera, so turning the surface costs nothing more.
import {
  DataTexture, DepthTexture, DoubleSide, FloatType, GLSL3, InstancedBufferGeometry, LessEqualCompare, LinearFilter, Mesh, NoBlending,
  OrthographicCamera, PlaneGeometry, RedFormat, RGBAFormat, Scene, ShaderMaterial, UnsignedIntType, WebGLRenderTarget,
} from 'three';

const kTiles = 8, kTileSize = 256;   // directions: the square of the first; a texel is 1/128 of the radius
const kWidth = 1024;                 // of the textures of points
const kPointsAtOnce = 64 * kWidth;

// The directions are a spiral on the sphere, with equal shares of it. `frame` turns page coordinates such that the
// direction is the third axis.
const kDirections = /* glsl */ `
uniform float radius;
mat3 frame(int i) {
  float z = 1.0 - (2.0 * float(i) + 1.0) / ${kTiles ** 2}.0, r = sqrt(1.0 - z * z), turn = 2.39996323 * float(i);
  vec3 d = vec3(r * cos(turn), z, r * sin(turn)), side = normalize(cross(vec3(0.31, 0.17, 0.93), d));
  return transpose(mat3(side, cross(d, side), d));
}
vec2 tile(int i) { return vec2(i % ${kTiles}, i / ${kTiles}); }`;

const kDepthVertex = /* glsl */ `
${kDirections}
uniform int first;
void main() {
  int i = first + gl_InstanceID;
  vec3 p = frame(i) * position / radius;
  gl_Position = vec4((p.xy * 0.5 + 0.5 + tile(i)) * ${2 / kTiles} - 1.0, -p.z, 1.0);
}`;

const kLookFragment = /* glsl */ `
${kDirections}
uniform sampler2D points, normals;
uniform vec3 up;
uniform float narrow;
uniform highp sampler2DShadow depths;
out vec4 seen;
void main() {
  vec3 n = texelFetch(normals, ivec2(gl_FragCoord.xy), 0).xyz;
  vec3 at = texelFetch(points, ivec2(gl_FragCoord.xy), 0).xyz + n * radius * ${(3 / kTileSize).toFixed(6)};
  float open = 0.0, all = 0.0;
  for (int i = 0; i < ${kTiles ** 2}; ++i) {
    mat3 turn = frame(i);
    vec3 d = vec3(turn[0].z, turn[1].z, turn[2].z);
    if (dot(d, n) <= 0.0) continue;
    float facing = pow(dot(d, n), narrow), light = mix(0.4, 1.0, smoothstep(-0.9, 0.4, dot(d, up)));
    vec3 p = turn * at / radius;
    all += facing;
    vec2 inside = clamp(p.xy * 0.5 + 0.5, 0.004, 0.996);
    open += facing * light * texture(depths, vec3((inside + tile(i)) * ${1 / kTiles}, 0.5 - 0.5 * p.z - 0.002));
  }
  seen = vec4(all > 0.0 ? open / all : 1.0, 0.0, 0.0, 1.0);
}`;

function make_texture(values) {
  const rows = Math.ceil(values.length / 3 / kWidth), texels = new Float32Array(4 * kWidth * rows);
  for (let i = 0; i < values.length / 3; ++i) for (let k = 0; k < 3; ++k) texels[4 * i + k] = values[3 * i + k];
  const texture = new DataTexture(texels, kWidth, rows, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

export class Sky {
  // The geometry lies inside a sphere of `radius` round the origin. Light from below the axis `up` counts less.
  constructor(renderer, geometry, radius, up) {
    this.renderer = renderer;
    this.camera = new OrthographicCamera();
    const depths = new DepthTexture(kTiles * kTileSize, kTiles * kTileSize, UnsignedIntType);
    depths.compareFunction = LessEqualCompare;
    depths.magFilter = depths.minFilter = LinearFilter;
    this.tiles = new WebGLRenderTarget(depths.image.width, depths.image.height, { format: RedFormat, depthTexture: depths });
    const uniforms = { radius, up, first: 0, narrow: 1, depths, points: null, normals: null };
    this.uniforms = Object.fromEntries(Object.entries(uniforms).map(([key, value]) => [key, { value }]));
    const draw_all = 'void main() { gl_Position = vec4(position, 1.0); }', empty = 'out vec4 none; void main() { none = vec4(1.0); }';
    const depth_material = { vertexShader: kDepthVertex, fragmentShader: empty, side: DoubleSide, colorWrite: false };
    const look_material = { vertexShader: draw_all, fragmentShader: kLookFragment, depthTest: false, depthWrite: false };
    this.copies = new InstancedBufferGeometry();
    this.copies.setAttribute('position', geometry.getAttribute('position'));
    if (geometry.index) this.copies.setIndex(geometry.index);
    this.surface = this.scene_of(this.copies, depth_material);
    this.quad = this.scene_of(new PlaneGeometry(2, 2), look_material);
  }

  scene_of(geometry, material) {
    const common = { glslVersion: GLSL3, uniforms: this.uniforms, blending: NoBlending };
    const mesh = new Mesh(geometry, new ShaderMaterial({ ...common, ...material }));
    mesh.frustumCulled = false;
    return new Scene().add(mesh);
  }

  draw(scene, target) {
    const { renderer } = this, { autoClear } = renderer;
    renderer.autoClear = false;
    renderer.setRenderTarget(target);
    renderer.render(scene, this.camera);
    renderer.setRenderTarget(null);
    renderer.autoClear = autoClear;
  }

  // Draws the depths, some directions at a time, with a pause after each; ends early where `pause` returns false.
  async prepare(pause) {
    const step = Math.max(1, Math.floor(600000 / this.copies.getAttribute('position').count));
    this.renderer.setRenderTarget(this.tiles);
    this.renderer.clear();
    for (let first = 0; first < kTiles ** 2; first += step) {
      this.uniforms.first.value = first;
      this.copies.instanceCount = Math.min(step, kTiles ** 2 - first);
      this.draw(this.surface, this.tiles);
      await pause();
    }
  }

  // The share of the sky that each of `points` sees in front of it, 0 to 255; some points at a time, so that the page stays
  // usable without a graphics card. The larger `narrow` is, the less light from the side counts.
  async look(points, normals, narrow = 1) {
    const shares = new Uint8Array(points.length / 3);
    for (let first = 0; first < shares.length; first += kPointsAtOnce) {
      const part = [3 * first, 3 * (first + kPointsAtOnce)], { uniforms, renderer } = this;
      uniforms.narrow.value = narrow;
      uniforms.points.value = make_texture(points.subarray(...part));
      uniforms.normals.value = make_texture(normals.subarray(...part));
      const { width, height } = uniforms.points.value.image, target = new WebGLRenderTarget(width, height, { depthBuffer: false });
      this.draw(this.quad, target);
      const pixels = new Uint8Array(4 * width * height);
      await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height, pixels);
      for (let i = first; i < Math.min(first + kPointsAtOnce, shares.length); ++i) shares[i] = pixels[4 * (i - first)];
      for (const used of [target, uniforms.points.value, uniforms.normals.value]) used.dispose();
    }
    return shares;
  }

  dispose() {
    this.tiles.dispose();
    this.tiles.depthTexture.dispose();
    this.copies.dispose();
  }
}
