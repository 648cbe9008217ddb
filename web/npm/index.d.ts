/** Exact geodesic Voronoi diagrams, distances, paths and remeshes on triangle meshes. Names are those of the commands. */

export const version: string;

export type ErrorCode = 'invalid_option' | 'unreadable_input' | 'precondition' | 'no_valid_result' | 'interrupted' |
  'out_of_memory' | 'internal_error';

/** What can't be done: `message` is one line, `element` the first offending one, -1 for none. */
export class Error extends globalThis.Error {
  code: ErrorCode;
  element: number;
}

type Numbers = ArrayLike<number>;

/** Points in faces: `bary` has three barycentric coordinates of each. */
export interface Points {
  face: Int32Array;
  bary: Float64Array;
}

/**
 * One or more points: a vertex or several; {face, bary}; positions, as a Float64Array or Float32Array or an array of
 * arrays of three, which move to the nearest points of the surface.
 */
export type PointsLike = number | number[] | Int32Array | Uint32Array | { face: Numbers; bary: Numbers } | number[][] |
  Float64Array | Float32Array;

/** How a call runs. */
export interface Run {
  /** Called ten times a second at most with a step and the fraction done; false ends the call. */
  progress?: ((step: string, fraction: number) => boolean | void) | null;
  /** Seconds above 0 after which the call ends with an error. */
  time_limit?: number | null;
}
interface NoRun {}
interface Weld extends Run {
  /** True joins vertices at the same place, a number also those at most so many mesh units apart. */
  weld?: boolean | number | null;
}

//= SampleOptions
//= PointOptions
//= DistanceOptions
//= PathOptions
//= MeasureOptions
//= CurveOptions
//= DiagramOptions
//= BalanceOptions
//= EditorOptions
//= EditOptions
//= LabelOptions
//= CutOptions
//= SegmentOptions
//= LloydOptions
//= RemeshOptions
//= MapOptions
//= SceneOptions
//= ReadOptions extends Weld
//= FileOptions extends NoRun

declare class Thing {
  /**
   * Frees the memory now; what was not asked of the object before can't be asked any more. Positions of results come from
   * their mesh, so free it last.
   */
  free(): void;
  /**
   * What was measured, by its names in the reports of the commands; `options` and `notes` are those of the call. A seed that a
   * number would round is a text there, which the option takes, too.
   */
  readonly figures: any;
  /**
   * The bytes of a file in the format of an extension: ply, obj, off, stl, vtp, vtu, glb, surf.gii, fs. Results other
   * than meshes have json, too, and diagrams txt and csv: the generators.
   */
  to_bytes(format: string, options?: FileOptions): Uint8Array;
}

/** A picture as the viewer's page reads it (docs/developer/viewer.md): `manifest` is JSON, `blobs` are its arrays. */
export interface Scene {
  manifest: string;
  blobs: Uint8Array[];
  /** Red, green and blue of each region, for the next scene. */
  colors: Uint8Array;
}

export type Summary = Record<'vertices' | 'edges' | 'faces' | 'components' | 'boundary_loops' | 'euler_characteristic' | 'area' |
  'bbox_diagonal', number>;

export interface Path {
  points: Points;
  positions: Float64Array;
  length: number;
  /** False where rounding ended the points at a vertex before the end; the length is right. */
  complete: boolean;
  /** Which of the ends is nearest; -1 where none can be reached. */
  end: number;
}

export interface Isoline {
  level: number;
  closed: boolean;
  points: Points;
  positions: Float64Array;
}

/** A triangle mesh: `vertices` has three coordinates each, `faces` three vertices each. */
export class Mesh extends Thing {
  /** `corners`: of each polygon, where `faces` is one flat array. */
  constructor(vertices: Numbers | number[][], faces: Numbers | number[][], options?: ReadOptions & { corners?: number | null });
  readonly vertices: Float64Array;
  readonly faces: Int32Array;
  /** The input's vertex for each vertex, -1 for the middle of a split edge; the input's polygon for each face. */
  readonly input_vertex: Int32Array;
  readonly input_face: Int32Array;
  /** The vertex that each vertex of the input became, -1 for none. */
  readonly vertex_of_input: Int32Array;
  /** u and v of each face's corners, v upwards, NaN where there are none; null without a texture. */
  readonly texture_coordinates: Float64Array | null;
  readonly summary: Summary;
  readonly area: number;
  /** The least and the largest coordinates. */
  readonly bounds: [number[], number[]];
  /** What was repaired, one line each. */
  readonly notes: string[];
  points(points: PointsLike, options?: PointOptions): Points;
  positions(points: PointsLike): Float64Array;
  sample(count?: number | null, options?: SampleOptions): Points;
  farthest(count: number, options?: SampleOptions): Points;
  /** Exact distances of all vertices, or of `to`, to the nearest point; `each`: a row for each point, one after the other. */
  distances(points: PointsLike | Curves, options?: DistanceOptions & { each?: boolean | null }): Float64Array;
  /** The rows of `distances(points, { each: true })`, one after the other, in the memory of one. */
  distance_rows(points: PointsLike, options?: DistanceOptions): Generator<Float64Array>;
  /** The distances, and which point is nearest. */
  nearest(points: PointsLike | Curves, options?: DistanceOptions): { distances: Float64Array; labels: Int32Array };
  /** What gvd-distance computes, with its files. */
  measure(points: PointsLike | Curves, options?: MeasureOptions): Distances;
  /** A shortest path to the nearest end; several starts, or a list of one: a path for each. A Float64Array of three is one position. */
  path(start: number, end: PointsLike | Curves, options?: PathOptions): Path;
  path(start: PointsLike, end: PointsLike | Curves, options?: PathOptions): Path | Path[];
  /**
   * The logarithm of every vertex at a point, two numbers each: the vector in whose direction the shortest path departs,
   * as long as that, mesh units. The x axis is the direction of the first edge at the point. NaN where no path leads.
   */
  log_map(point: PointsLike, options?: PathOptions): Float64Array;
  /**
   * Curves as generators: the boundary; the creases, whose faces differ by more than `angle` degrees (default 40), or
   * 'creases:30' in one;
   * polylines through points, which `closed` closes; or those of the bytes of a file with this `name`.
   */
  curves(curves: 'boundary' | 'creases' | `creases:${number}` | PointsLike[] | Uint8Array | ArrayBuffer,
         options?: CurveOptions & { closed?: boolean | null; angle?: number | null; name?: string | null }): Curves;
  /** Curves of equal distance at these levels, ascending, or at each multiple of a number. */
  isolines(points: PointsLike | Curves, levels: number | Numbers, options?: PathOptions): Isoline[];
  voronoi(points: PointsLike | Curves, options?: DiagramOptions): Diagram;
  /** The diagram whose weights give all cells the same area, or the same integral of `density`, or their `shares`. */
  balance(points: PointsLike, options?: BalanceOptions & { density?: Numbers | null }): Balanced;
  /** As gvd-segment; with `cut` or `uv` it splits faces. */
  segment(count: number | null | undefined, options: SegmentOptions & { cut: true; uv?: CutOptions['uv'] }): Cut;
  segment(count: number | null | undefined, options: SegmentOptions & { uv: 'logmap' | 'flat' }): Cut;
  segment(count?: number | null, options?: SegmentOptions): Segmentation;
  /** As gvd-lloyd. `on_iteration` is called with the iterations so far, the energy and the generators. */
  lloyd(count?: number | null, options?: LloydOptions &
        { on_iteration?: ((iterations: number, energy: number, generators: Points) => void) | null }): Relaxation;
  /** As gvd-remesh. */
  remesh(count?: number | null, options?: RemeshOptions): Remesh;
}

/** Curves of a mesh; `positions` has the polylines of each, three coordinates a point. */
export class Curves {
  private constructor();
  readonly positions: Float64Array[][];
  readonly length: number;
}

/** Distances from the nearest source: of all vertices, and what gvd-distance adds to them. */
export interface Distances extends Thing {
  readonly mesh: Mesh;
  readonly distances: Float64Array;
  readonly labels: Int32Array;
  readonly paths: Path[];
  readonly isolines: Isoline[];
  scene(options?: SceneOptions): Scene;
}

export interface Bisector {
  left: number;
  right: number;
  closed: boolean;
  ends: [number, number];
  points: Points;
  positions: Float64Array;
}

/** The points of three and more cells; `generators` of each, counter-clockwise. */
export interface BranchPoints {
  points: Points;
  positions: Float64Array;
  distances: Float64Array;
  generators: Int32Array[];
}

export interface Cell {
  generator: number;
  area: number;
  euler_characteristic: number;
  components: number;
  boundary_loops: number;
  neighbours: Int32Array;
}

export class Diagram extends Thing {
  readonly mesh: Mesh;
  /** The area of each cell. */
  readonly areas: Float64Array;
  /** The nearest generator of each vertex, -1 for none, and its distance. */
  readonly labels: Int32Array;
  readonly distances: Float64Array;
  /** The generator of each face that lies in one cell, -1 for faces that bisectors cut. */
  readonly face_labels: Int32Array;
  readonly weights: Float64Array;
  readonly generators: Points;
  readonly length: number;
  readonly branch_points: BranchPoints;
  readonly bisectors: Bisector[];
  /** The bisectors in flat arrays; those of i have the points first[i] to first[i + 1] - 1. */
  readonly curves: { first: Int32Array; left: Int32Array; right: Int32Array; closed: Int32Array; ends: Int32Array;
                     points: Points; positions: Float64Array };
  readonly cells: Cell[];
  /** The faces that bisectors cut, in triangles: nine coordinates each. */
  readonly pieces: { positions: Float32Array; face: Int32Array; label: Int32Array };
  /** What violates the invariants of a diagram: normally nothing. */
  check(): string[];
  segment(options?: LabelOptions): Segmentation;
  /** `uv` gives the pieces texture coordinates; "flat" needs cells that are discs. */
  cut(options?: CutOptions): Cut;
  scene(options?: SceneOptions): Scene;
}

/**
 * An exact diagram of which one generator after the other is moved, added or removed. Each change computes again what it
 * has an effect on; the diagram is that of `mesh.voronoi(generators)`, bit for bit unless shortest paths tie.
 * Throws `precondition` for a generator that does not exist, a point on another generator, and the last one's removal.
 */
export class DiagramEditor {
  constructor(mesh: Mesh, points: PointsLike, options?: EditorOptions);
  readonly mesh: Mesh;
  /** Of the present generators; it stays as it is when the editor changes. */
  readonly diagram: Diagram;
  readonly generators: Points;
  move(generator: number, to: PointsLike, options?: EditOptions): this;
  /** The new generator has the next number. */
  add(point: PointsLike, options?: EditOptions): this;
  /** The last generator gets the number of the one that is removed. */
  remove(generator: number, options?: EditOptions): this;
  /** Frees the present diagram, unless somebody has asked for it. */
  free(): void;
  to_bytes(format: string, options?: FileOptions): Uint8Array;
}

export interface Balanced {
  diagram: Diagram;
  masses: Float64Array;
  targets: Float64Array;
  tied: Int32Array[];
  converged: boolean;
}

declare class Result extends Thing {
  readonly diagram: Diagram;
  readonly generators: Points;
}

export class Segmentation extends Result {
  readonly mesh: Mesh;
  /** The area of the faces of each label. */
  readonly areas: Float64Array;
  readonly labels: Int32Array;
  readonly without_face: Int32Array;
  readonly border_length: number;
  /** The region of each face as `within` gave it, or null. */
  readonly regions: Int32Array | null;
  /** The labels of each level of `levels`, from the coarsest to `labels`. */
  readonly levels: Int32Array[];
}

/**
 * A connected part of a region in the unit square: its area on the surface, the shares of it that are flipped or torn off,
 * its largest stretch, the least and the largest corner of its box, and the place of its generator.
 */
export interface Chart {
  label: number;
  faces: number;
  area: number;
  flipped_share: number;
  torn_share: number;
  stretch: number;
  box: [[number, number], [number, number]] | [];
  origin: [number, number];
}

export class Cut extends Result {
  readonly mesh: Mesh;
  readonly labels: Int32Array;
  readonly parents: Int32Array;
  readonly vertex_labels: Int32Array;
  readonly distances: Float64Array;
  /** The charts of the texture coordinates of `mesh`, by their first face, and texture units per mesh unit; without `uv` none and 0. */
  readonly charts: Chart[];
  readonly scale: number;
}

export class Relaxation extends Result {
  readonly energies: Float64Array;
  readonly areas: Float64Array;
  readonly cell_energies: Float64Array;
  readonly residual: number;
  readonly stop: string;
  /** The generators with normals, areas and energies, as gvd-lloyd --points writes them. */
  points_to_bytes(format: 'ply' | 'xyz' | 'npy'): Uint8Array;
}

export class Remesh extends Result {
  readonly surface: Mesh;
  readonly mesh: Mesh;
  /** What holds of every remesh: what has no certificate is an error. */
  readonly certificate: { ok: true; manifold: boolean; closed_as_input: boolean; same_euler_characteristic: boolean;
                          same_components: boolean; same_boundary_loops: boolean; same_in_each_component: boolean;
                          flipped_faces: number; unused_generators: number; self_intersections: number;
                          inherited_intersections: number; intersections_allowed: boolean };
  map(options?: MapOptions): RemeshMap;
  /** The coarse mesh, with the input over it. */
  scene(options?: SceneOptions): Scene;
}

/**
 * For each vertex of the surface its point of the remesh, and for each of the remesh its point of the surface; whether
 * both come from a map that was checked to be one-to-one. `to_bytes('json')` is the file of gvd-remesh --map.
 */
export class RemeshMap extends Thing {
  readonly points: Points;
  readonly origins: Points;
  readonly one_to_one: boolean;
}

/**
 * Reads the bytes of an OBJ, PLY, OFF, STL, glTF (buffers inside), MNI or legacy VTK file; `name` is the file's, for messages.
 */
export function read(bytes: Uint8Array | ArrayBuffer, name: string, options?: ReadOptions): Mesh;

/** The numbers of a file that has one for each vertex or face: text, .npy, and FreeSurfer's .annot and values. */
export function read_values(bytes: Uint8Array | ArrayBuffer, name: string): Float64Array;

/** The properties of a PLY or OBJ but coordinates and texture: of its vertices and of its faces, by their names. */
export function read_properties(bytes: Uint8Array | ArrayBuffer, name: string):
  { vertex: Record<string, Float64Array>; face: Record<string, Float64Array> };

/** The bytes that gzip packed, as `read` takes them; other bytes as they are. */
export function unpack(bytes: Uint8Array | ArrayBuffer): Promise<Uint8Array | ArrayBuffer>;
