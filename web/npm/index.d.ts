/** Exact geodesic Voronoi diagrams, distances, paths and remeshes on triangle meshes. Names are those of Python. */

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

/** Called ten times a second at most with a step and the fraction done; false cancels. */
type Progress = (step: string, fraction: number) => boolean | void;

interface Reporting {
  progress?: Progress;
}

export interface ComputeOptions extends Reporting {
  method?: 'exact' | 'gbgvd' | 'paper';
  front?: 'planar' | 'circle';
  /** Largest distance of bisectors from their curves, in mean edge lengths. */
  chord_tolerance?: number;
}

export interface SampleOptions extends Reporting {
  sampling?: 'farthest' | 'random' | 'vertices' | 'poisson';
  seed?: number;
  /** In place of n: as many points as leave none farther than this from the nearest one, mesh units. */
  radius?: number;
}

interface RelaxOptions extends SampleOptions, ComputeOptions {
  generators?: PointsLike;
  fixed?: PointsLike;
  /** Angle of creases that generators keep to, degrees, or whether they are found. */
  features?: number | 'auto' | 'none';
  keep_boundary?: boolean;
  /** A number above 0 for each vertex or face; larger ones make smaller cells. */
  density?: 'curvature' | Numbers;
  gradation?: number;
  coarse?: number;
}

export interface SegmentOptions extends SampleOptions, ComputeOptions {
  generators?: PointsLike;
  /** Short borders, or the largest share of each face. */
  labels?: 'smooth' | 'nearest';
  /** A whole number for each face or vertex: no region crosses the borders between them. */
  within?: Numbers;
  /** Not 0 for each face or vertex to leave out. */
  mask?: Numbers | boolean[];
  /** In place of n: points of each region of `within`, or ascending numbers, each level inside the one before. */
  per_region?: number;
  levels?: Numbers;
  /** Adds points until each cell is a disc. */
  disc?: boolean;
}

export interface LloydOptions extends RelaxOptions {
  accelerate?: 'lbfgs' | 'anderson' | 'none';
  relocate?: boolean;
  iterations?: number;
  tolerance?: number;
  move_tolerance?: number;
  step?: number;
  /** Called with the iterations so far, the energy and the generators. */
  on_iteration?: (iterations: number, energy: number, generators: Points) => void;
}

export interface RemeshOptions extends RelaxOptions {
  /** In place of n: the mean length of edges, or the largest distance from the surface; mesh units. */
  target_edge?: number;
  error?: number;
  relax?: number;
  loose_boundary?: boolean;
  place?: 'generator' | 'quadric' | 'fit';
  shape?: number;
  exact_count?: boolean;
  max_added?: number;
  no_refine?: boolean;
  allow_intersections?: boolean;
}

interface WriteOptions {
  no_curves?: boolean;
  ascii_ply?: boolean;
  region_materials?: boolean;
}

declare class Handle {
  /** Frees the memory now; nothing may be asked of the object any more. */
  free(): void;
  /**
   * The bytes of a file in the format of an extension: ply, obj, off, stl, vtp, vtu, glb, surf.gii, fs. Results other
   * than meshes have json, too, and diagrams txt and csv: the generators.
   */
  to_bytes(format: string, options?: WriteOptions): Uint8Array;
}

export interface Summary {
  vertices: number;
  edges: number;
  faces: number;
  components: number;
  boundary_loops: number;
  euler_characteristic: number;
  area: number;
  bbox_diagonal: number;
}

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
export class Mesh extends Handle {
  /** `corners`: of each polygon, where `faces` is one flat array. */
  constructor(vertices: Numbers | number[][], faces: Numbers | number[][],
              options?: { on_defect?: 'error' | 'repair' | 'largest'; corners?: number });
  readonly vertices: Float64Array;
  readonly faces: Int32Array;
  readonly input_vertex: Int32Array;
  readonly input_face: Int32Array;
  /** u and v of each face's corners, v upwards, NaN where there are none; null without a texture. */
  readonly texture_coordinates: Float64Array | null;
  readonly summary: Summary;
  /** What was repaired, one line each. */
  readonly notes: string[];
  points(points: PointsLike, options?: { max_snap?: number }): Points;
  positions(points: PointsLike): Float64Array;
  sample(n?: number | null, options?: SampleOptions): Points;
  farthest(n: number, options?: SampleOptions): Points;
  /** Exact distances of all vertices, or of `at`, to the nearest point; `each`: a row for each point, one after the other. */
  distances(points: PointsLike | Curves, options?: { each?: boolean; at?: PointsLike } & Reporting): Float64Array;
  /** The rows of `distances(points, { each: true })`, one after the other, in the memory of one. */
  distance_rows(points: PointsLike, options?: { at?: PointsLike } & Reporting): Generator<Float64Array>;
  /** The distances, and which point is nearest. */
  nearest(points: PointsLike | Curves, options?: { at?: PointsLike } & Reporting): { distances: Float64Array; labels: Int32Array };
  /** A shortest path to the nearest end; several starts: a path for each. */
  path(start: number, end: PointsLike, options?: Reporting): Path;
  path(start: PointsLike, end: PointsLike, options?: Reporting): Path | Path[];
  /**
   * The logarithm of every vertex at a point, two numbers each: the vector in whose direction the shortest path departs,
   * as long as that, mesh units. The x axis is the direction of the first edge at the point. NaN where no path leads.
   */
  log_map(point: PointsLike, options?: Reporting): Float64Array;
  /**
   * Curves as generators: the boundary; the creases, whose faces differ by more than `angle` degrees (default 40);
   * polylines through points, which `closed` closes; or those of the bytes of a file with this `name`.
   */
  curves(curves: 'boundary' | 'creases' | PointsLike[] | Uint8Array | ArrayBuffer,
         options?: { closed?: boolean; angle?: number; max_snap?: number; name?: string }): Curves;
  /** Curves of equal distance at these levels, ascending, above 0. */
  isolines(points: PointsLike, levels: Numbers, options?: Reporting): Isoline[];
  voronoi(points: PointsLike | Curves,
          options?: { max_snap?: number; merge_coincident?: boolean; weights?: Numbers } & ComputeOptions): Diagram;
  balance(points: PointsLike, options?: { density?: Numbers; shares?: Numbers; weights?: Numbers } & Reporting): Balanced;
  segment(n?: number | null, options?: SegmentOptions): Segmentation;
  lloyd(n?: number | null, options?: LloydOptions): Relaxation;
  remesh(n?: number | null, options?: RemeshOptions): Remesh;
}

/** Curves of a mesh; `positions` has the polylines of each, three coordinates a point. */
export class Curves extends Handle {
  readonly positions: Float64Array[][];
  readonly length: number;
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

export class Diagram extends Handle {
  readonly mesh: Mesh;
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
  segment(options?: { labels?: 'smooth' | 'nearest' } & Reporting): Segmentation;
  /** `uv` gives the pieces texture coordinates; "flat" needs cells that are discs. */
  cut(options?: { uv?: 'logmap' | 'flat' } & Reporting): Cut;
}

/**
 * An exact diagram of which one generator after the other is moved, added or removed. Each change computes again what it
 * has an effect on; the diagram is that of `mesh.voronoi(generators)`, bit for bit unless shortest paths tie.
 * Throws `precondition` for a generator that does not exist, a point on another generator, and the last one's removal.
 */
export class DiagramEditor extends Handle {
  constructor(mesh: Mesh, points: PointsLike, options?: { max_snap?: number } & ComputeOptions);
  readonly mesh: Mesh;
  /** Of the present generators; it stays as it is when the editor changes. */
  readonly diagram: Diagram;
  readonly generators: Points;
  move(generator: number, to: PointsLike): this;
  /** The new generator has the next number. */
  add(point: PointsLike): this;
  /** The last generator gets the number of the one that is removed. */
  remove(generator: number): this;
}

export interface Balanced {
  diagram: Diagram;
  masses: Float64Array;
  targets: Float64Array;
  tied: Int32Array[];
  converged: boolean;
}

export class Segmentation extends Handle {
  readonly diagram: Diagram;
  readonly labels: Int32Array;
  readonly without_face: Int32Array;
  readonly border_length: number;
  /** The region of each face as `within` gave it, or null. */
  readonly regions: Int32Array | null;
  /** The labels of each level of `levels`, from the coarsest to `labels`. */
  readonly levels: Int32Array[];
}

/** A connected part of a region in the unit square. Areas are those of faces on the surface, square mesh units. */
export interface Chart {
  label: number;
  faces: number;
  area: number;
  flipped_area: number;
  torn_area: number;
  unplaced_area: number;
  stretch: number;
  box: [[number, number], [number, number]];
  origin: [number, number];
}

export class Cut extends Handle {
  readonly diagram: Diagram;
  readonly mesh: Mesh;
  readonly labels: Int32Array;
  readonly parents: Int32Array;
  readonly vertex_labels: Int32Array;
  readonly distances: Float64Array;
  /** The charts of the texture coordinates of `mesh`, by their first face, and texture units per mesh unit; without `uv` none and 0. */
  readonly charts: Chart[];
  readonly scale: number;
}

export class Relaxation extends Handle {
  readonly diagram: Diagram;
  readonly generators: Points;
  readonly energies: Float64Array;
  readonly areas: Float64Array;
  readonly cell_energies: Float64Array;
  readonly residual: number;
  readonly stop: string;
  /** The generators with normals, areas and energies, as gvd-lloyd --points writes them. */
  points_to_bytes(format: 'ply' | 'xyz' | 'npy'): Uint8Array;
}

interface Distance {
  hausdorff: number;
  rms: number;
}

export class Remesh extends Handle {
  readonly surface: Mesh;
  readonly mesh: Mesh;
  readonly diagram: Diagram;
  readonly figures: { added: number; left_out: number; input_to_output: Distance; output_to_input: Distance;
                      q_average: number; angle_min: number };
  readonly certificate: { ok: boolean; manifold: boolean; closed_as_input: boolean; same_euler_characteristic: boolean;
                          same_components: boolean; same_boundary_loops: boolean; same_in_each_component: boolean;
                          flipped_faces: number; self_intersections: number; inherited_intersections: number };
  map(options?: Reporting): RemeshMap;
}

/**
 * For each vertex of the surface its point of the remesh, and for each of the remesh its point of the surface; whether
 * both come from a map that was checked to be one-to-one. `to_bytes('json')` is the file of gvd-remesh --map.
 */
export class RemeshMap extends Handle {
  readonly points: Points;
  readonly origins: Points;
  readonly one_to_one: boolean;
}

/**
 * Reads the bytes of an OBJ, PLY, OFF, STL, glTF (buffers inside), MNI or legacy VTK file; `name` is the file's, for messages.
 * `weld`: true joins vertices at the same place, a number also those at most so many mesh units apart.
 */
export function read(bytes: Uint8Array | ArrayBuffer, name: string,
                     options?: { on_defect?: 'error' | 'repair' | 'largest'; weld?: boolean | number | null }): Mesh;

/** The numbers of a file that has one for each vertex or face: text, .npy, and FreeSurfer's .annot and values. */
export function read_values(bytes: Uint8Array | ArrayBuffer, name: string): Float64Array;

/** The bytes that gzip packed, as `read` takes them; other bytes as they are. */
export function unpack(bytes: Uint8Array | ArrayBuffer): Promise<Uint8Array | ArrayBuffer>;
