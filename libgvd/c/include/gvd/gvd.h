#ifndef GVD_GVD_H
#define GVD_GVD_H

/*
 * The C interface of libgvd: exact geodesic distances, paths and Voronoi diagrams on triangle meshes, and what the
 * commands make of them. For languages that call C: Julia, Rust, C#, MATLAB, Python's ctypes. C++ has gvd/gvd.hpp.
 *
 * Conventions. A function that can fail returns a gvd_status and writes its results only where that is GVD_OK;
 * gvd_last_error() then has one line for the user. Handles are opaque; each has a function that frees it, which takes
 * NULL too. Arrays belong to the caller, who gives them the length that the comment names; vertices and faces are
 * row-major. Indices are 0-based. Lengths are in the mesh's units. Strings are UTF-8 and end with a 0. A handle may be
 * read by several threads at once. The same input gives the same results, to the last bit, as the commands give, with
 * any number of threads.
 */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GVD_API __attribute__((visibility("default")))

/* The values are the exit codes of the commands, except GVD_OUT_OF_MEMORY: they end with 5 then. */
typedef enum gvd_status {
  GVD_OK = 0,
  GVD_OUT_OF_MEMORY = 1,
  GVD_INVALID_OPTION = 2,    /* an argument is out of its range, or NULL where it must not be */
  GVD_UNREADABLE_INPUT = 3,  /* a file is missing, is no mesh, or is damaged */
  GVD_PRECONDITION = 4,      /* the input breaks a stated precondition */
  GVD_NO_VALID_RESULT = 5,   /* no valid result exists */
  GVD_UNWRITABLE_OUTPUT = 6, /* a file could not be written */
  GVD_INTERNAL_ERROR = 70,   /* a fault of the library */
  GVD_INTERRUPTED = 130      /* the progress callback or the flag `cancel` asked to stop */
} gvd_status;

/* What went wrong in the last call of this thread that failed, where, and what to do; valid until the next one fails.
 */
GVD_API const char* gvd_last_error(void);
/* Its code by its name, such as "precondition"; empty for those that are no gvd_status of input, options or results. */
GVD_API const char* gvd_last_error_code(void);
/* The 0-based index of the first offending element, -1 where there is none. */
GVD_API int64_t gvd_last_error_element(void);
/* The version of the library, such as "0.2.0". */
GVD_API const char* gvd_version(void);

/* A mesh, a diagram, or the result of an operation. It keeps alive what it was made of, and never changes. */
typedef struct gvd_object gvd_object;

/* How a call runs; NULL stands for all zeros. */
typedef struct gvd_run {
  int threads; /* 0: one a core */
  /* Called by the calling thread with the name of a step and the fraction of it that is done; 0 cancels. May be NULL.
   */
  int (*progress)(void* data, const char* step, double fraction);
  void* data; /* for `progress`, `note` and `iteration` */
  /* Cancels the call once it is not 0: any thread may set it. May be NULL. */
  const int32_t* cancel;
  /* Called by the calling thread with what users should not miss, a line each. May be NULL. */
  void (*note)(void* data, const char* text);
  /* Where this is not NULL, `progress` is called only once it is not 0, which the call then makes 0: so a clock of the
   * caller's says how often. */
  int32_t* due;
  int32_t door; /* how texts write options: one of the constants below */
  /* Called by the calling thread before the first iteration of lloyd and after each, with the number of iterations so
   * far, the energy, and the generators: an object with the arrays points_faces and points_bary that lasts until this
   * returns. May be NULL.
   */
  void (*iteration)(void* data, int32_t iterations, double energy, const gvd_object* points);
} gvd_run;

enum { GVD_JSON = 0, GVD_PYTHON = 1, GVD_JAVASCRIPT = 2 }; /* "count": 30, count=30, count: 30 */

/* ---- Objects, and operations on them ---- */

/* Objects may be released in any order. NULL is released, too. */
GVD_API void gvd_release(gvd_object* object);

enum {
  GVD_INT8 = 0,
  GVD_UINT8 = 1,
  GVD_INT16 = 2,
  GVD_UINT16 = 3,
  GVD_INT32 = 4,
  GVD_UINT32 = 5,
  GVD_INT64 = 6,
  GVD_UINT64 = 7,
  GVD_FLOAT32 = 8,
  GVD_FLOAT64 = 9
};
typedef int32_t gvd_type; /* one of the constants above */

/* Numbers in somebody's memory, in one or two dimensions. */
typedef struct gvd_array {
  const void* data;
  gvd_type type;
  int32_t dimensions; /* 1 or 2 */
  int64_t shape[2];
  int64_t strides[2]; /* bytes from one element to the next; may be negative */
} gvd_array;

/* The number of this interface. It changes where a program has to be compiled again. */
#define GVD_ABI 1

/* Runs an operation on an object of the kind that gvd_describe() says; NULL where it takes none, as the operation
 * "mesh" that makes one. `abi`: GVD_ABI. `options`: a JSON object, as {"count": 30, "density": {"array": 0}}, where
 * {"array": 0} is the first one of `arrays`; NULL: none. Numbers may be strings: JSON has no infinity. `arrays`:
 * `count` of them, which the call reads and does not keep; NULL where there is none. gvd_describe() has the operations
 * and their options. */
GVD_API gvd_status gvd_call(int32_t abi, const char* operation, const gvd_object* on, const char* options,
                            const gvd_array* arrays, int32_t count, const gvd_run* run, gvd_object** result);
/* An array of an object, by the name that gvd_describe() has. It lives as long as the object. What the object lacks is
 * an array of length 0. Points are two arrays, NAME_faces and NAME_bary; curves have NAME_offsets, too: the place of
 * the first point of each, and the number of all. */
GVD_API gvd_status gvd_array_of(const gvd_object* object, const char* name, gvd_array* view);
/* A part of an object, such as the diagram of a result; to be released by itself. One that the options of the result do
 * not make is GVD_INVALID_OPTION. */
GVD_API gvd_status gvd_object_of(const gvd_object* object, const char* name, gvd_object** part);
/* The figures of an object as JSON, and of a result its options and notes. The options can be given to gvd_call again,
 * with the same arrays. Lives as long as the object. */
GVD_API const char* gvd_figures(const gvd_object* object);
/* Writes what an object is, as the command writes it with -o: by the extension of the file. GVD_INVALID_OPTION where
 * that format would lose what was asked for, as the command says, too. */
GVD_API gvd_status gvd_write(const gvd_object* object, const char* path, const gvd_run* run);
/* The same with options, as {"ascii_ply": true}; NULL: none. They are the `file_options` of gvd_describe(). */
GVD_API gvd_status gvd_write_as(const gvd_object* object, const char* path, const char* options, const gvd_run* run);
/* The bytes of that file, without one: an object whose array "bytes" has them. `format`: an extension, as "ply". */
GVD_API gvd_status gvd_file_of(const gvd_object* object, const char* format, const char* options, const gvd_run* run,
                               gvd_object** file);
/* The operations with their options and results, the kinds of objects and the formats, as JSON. */
GVD_API const char* gvd_describe(void);
/* The same, with options as a door writes them: GVD_PYTHON, for instance. */
GVD_API const char* gvd_describe_for(int32_t door);

/* ---- Meshes ---- */

/* A mesh is an object of its own kind. */
typedef gvd_object gvd_mesh;

/* Reads a mesh file. Defects are repaired if `repair` is not 0, where no part of the surface is lost by that; otherwise
 * they are refused with GVD_PRECONDITION. */
GVD_API gvd_status gvd_mesh_read(const char* path, int repair, gvd_mesh** mesh);
/* As gvd_mesh_read, and joins vertices at the same position, as those of an STL are; with a tolerance above 0 (mesh
 * units) also those at most so far apart, as --weld does. */
GVD_API gvd_status gvd_mesh_read_welded(const char* path, int repair, double tolerance, gvd_mesh** mesh);
/* Makes a mesh of `vertex_count` positions (3 numbers each) and `face_count` triangles (3 vertices each). */
GVD_API gvd_status gvd_mesh_create(const double* vertices, int64_t vertex_count, const int32_t* faces,
                                   int64_t face_count, int repair, gvd_mesh** mesh);
GVD_API void gvd_mesh_free(gvd_mesh* mesh);

/* What was repaired, one line each; empty for nothing. Valid as long as the mesh. */
GVD_API const char* gvd_mesh_repairs(const gvd_mesh* mesh);
GVD_API int32_t gvd_mesh_vertex_count(const gvd_mesh* mesh);
GVD_API int32_t gvd_mesh_face_count(const gvd_mesh* mesh);
/* Vertices are those of the mesh. Repairs and welding make others than those of the file or of the arrays, which have
 * `input_vertex_count`; gvd_mesh_vertex_of_input tells which one an input vertex became, -1 where it is in no face. */
GVD_API int64_t gvd_mesh_input_vertex_count(const gvd_mesh* mesh);
GVD_API int32_t gvd_mesh_vertex_of_input(const gvd_mesh* mesh, int64_t vertex);
/* vertices: 3 x vertex_count */
GVD_API void gvd_mesh_vertices(const gvd_mesh* mesh, double* vertices);
/* faces: 3 x face_count */
GVD_API void gvd_mesh_faces(const gvd_mesh* mesh, int32_t* faces);
/* Writes the mesh in the format of the extension: ply, obj, off, coff, stl, vtp, vtu, glb, surf.gii or fs. */
GVD_API gvd_status gvd_mesh_write(const gvd_mesh* mesh, const char* path);

/* ---- Points of a surface ---- */

typedef struct gvd_point {
  int32_t face;
  double bary[3]; /* barycentric coordinates in the face, in [0, 1], of sum 1 */
} gvd_point;

/* The point at a vertex of the file or of the arrays that the mesh was made of. */
GVD_API gvd_status gvd_point_at_vertex(const gvd_mesh* mesh, int64_t vertex, gvd_point* point);
/* The point of the surface nearest to a position, and its distance from there, which may be NULL. The first call for a
 * mesh builds a tree, in O(n log n). */
GVD_API gvd_status gvd_point_near(const gvd_mesh* mesh, const double position[3], gvd_point* point, double* distance);
GVD_API gvd_status gvd_point_position(const gvd_mesh* mesh, const gvd_point* point, double position[3]);

enum { GVD_FARTHEST = 0, GVD_RANDOM = 1, GVD_POISSON = 2, GVD_VERTICES = 3 };
typedef int32_t gvd_sampling; /* one of the constants above; any other number is GVD_INVALID_OPTION */

/* Spreads `count` points over the surface. points: count */
GVD_API gvd_status gvd_sample(const gvd_mesh* mesh, int32_t count, gvd_sampling kind, uint64_t seed, const gvd_run* run,
                              gvd_point* points);

/* ---- Exact distances and shortest paths ---- */

/* Distances of all vertices from the nearest source, infinity where none reaches; `nearest` gets that source, -1 for
 * none, and may be NULL. One call for each source gives a matrix row by row. distances, nearest: vertex_count */
GVD_API gvd_status gvd_distances(const gvd_mesh* mesh, const gvd_point* sources, int32_t source_count,
                                 const gvd_run* run, double* distances, int32_t* nearest);

typedef struct gvd_path gvd_path;

/* A shortest path from one point to another. GVD_NO_VALID_RESULT where they are in different components. */
GVD_API gvd_status gvd_path_compute(const gvd_mesh* mesh, const gvd_point* from, const gvd_point* to,
                                    const gvd_run* run, gvd_path** path);
GVD_API void gvd_path_free(gvd_path* path);
GVD_API double gvd_path_length(const gvd_path* path);
GVD_API int32_t gvd_path_point_count(const gvd_path* path);
/* Both ends included; neighbours share a face. points: point_count */
GVD_API void gvd_path_points(const gvd_path* path, gvd_point* points);

/* ---- Voronoi diagrams and segmentations ---- */

/* A diagram is an object of its own kind. */
typedef gvd_object gvd_diagram;

enum { GVD_EXACT = 0, GVD_GBGVD = 1, GVD_PAPER = 2 };
typedef int32_t gvd_method; /* one of the constants above; any other number is GVD_INVALID_OPTION */

/* The diagram of `count` generators. The mesh may be freed before the diagram. */
GVD_API gvd_status gvd_diagram_compute(const gvd_mesh* mesh, const gvd_point* generators, int32_t count,
                                       gvd_method method, const gvd_run* run, gvd_diagram** diagram);
GVD_API void gvd_diagram_free(gvd_diagram* diagram);

/* The nearest generator of every vertex, -1 for none, and its distance. Either may be NULL. vertex_count each */
GVD_API void gvd_diagram_vertices(const gvd_diagram* diagram, int32_t* labels, double* distances);
/* The area of every cell. areas: count */
GVD_API void gvd_diagram_areas(const gvd_diagram* diagram, double* areas);

GVD_API int32_t gvd_diagram_branch_point_count(const gvd_diagram* diagram);
/* Points of three or more cells, and their distances, which may be NULL. branch_point_count each */
GVD_API void gvd_diagram_branch_points(const gvd_diagram* diagram, gvd_point* points, double* distances);

typedef struct gvd_bisector {
  int32_t left, right; /* the cells on both sides along the points, seen from outside */
  int32_t ends[2];     /* its branch points; -1 on the mesh's boundary, and where it is closed */
  int32_t closed;      /* 1: the first point follows the last */
  int32_t point_count;
} gvd_bisector;

GVD_API int32_t gvd_diagram_bisector_count(const gvd_diagram* diagram);
GVD_API gvd_status gvd_diagram_bisector(const gvd_diagram* diagram, int32_t index, gvd_bisector* bisector);
/* points: point_count of the bisector */
GVD_API gvd_status gvd_diagram_bisector_points(const gvd_diagram* diagram, int32_t index, gvd_point* points);

/* Labels every face with a generator, -1 for none: each label's faces are connected. As gvd-segment does; borders are
 * smooth if `smooth` is not 0. labels: face_count */
GVD_API gvd_status gvd_segment(const gvd_diagram* diagram, int smooth, const gvd_run* run, int32_t* labels);
/* Writes what gvd-segment -o writes, with smooth borders, in the format of the extension. */
GVD_API gvd_status gvd_segment_write(const gvd_diagram* diagram, const char* path, const gvd_run* run);

/* ---- Relaxation ---- */

typedef struct gvd_lloyd_options {
  int32_t iterations;  /* the most; below 0: the default */
  double tolerance;    /* as --tolerance; below 0: the default */
  double crease_angle; /* keep generators on sharper edges, degrees; 0: none */
  int32_t keep_boundary;
  gvd_sampling sampling; /* of the first generators, where none are given */
  uint64_t seed;
} gvd_lloyd_options;

GVD_API void gvd_lloyd_defaults(gvd_lloyd_options* options);
/* Moves `count` generators to the centroids of their cells, as gvd-lloyd does. `given`: the first generators; NULL:
 * they are sampled. `options` may be NULL. `energy`, in units to the fourth, may be NULL. relaxed: count */
GVD_API gvd_status gvd_lloyd(const gvd_mesh* mesh, const gvd_point* given, int32_t count,
                             const gvd_lloyd_options* options, const gvd_run* run, gvd_point* relaxed, double* energy);

/* ---- Remeshes ---- */

typedef struct gvd_remesh_options {
  int32_t relaxation;     /* iterations; below 0: the default */
  int32_t exact_count;    /* exactly `count` vertices, or GVD_NO_VALID_RESULT */
  double crease_angle;    /* degrees; 0: none, below 0: those that count generators can follow */
  int32_t loose_boundary; /* put no generators on the boundary */
  gvd_sampling sampling;
  uint64_t seed;
} gvd_remesh_options;

GVD_API void gvd_remesh_defaults(gvd_remesh_options* options);
/* The coarse mesh that is dual to the diagram of `count` generators and those that are added, as gvd-remesh makes it.
 * `given` and `options`: as for gvd_lloyd. */
GVD_API gvd_status gvd_remesh(const gvd_mesh* mesh, const gvd_point* given, int32_t count,
                              const gvd_remesh_options* options, const gvd_run* run, gvd_mesh** coarse);
/* The generator of every vertex of a remesh: its point of the mesh that the remesh was made of. GVD_INVALID_OPTION for
 * a mesh that gvd_remesh has not made. points: vertex_count */
GVD_API gvd_status gvd_mesh_generators(const gvd_mesh* coarse, gvd_point* points);

#ifdef __cplusplus
}
#endif

#endif
