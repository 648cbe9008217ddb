#ifndef GVD_GVD_H
#define GVD_GVD_H

/*
 * The C interface of libgvd: exact geodesic distances, paths and Voronoi diagrams on triangle meshes, and the
 * operations of the commands. For languages that call C: Julia, Rust, C#, MATLAB, Python's ctypes. C++ has gvd/gvd.hpp.
 *
 * Conventions. A function that can fail returns a gvd_status and writes its results only if that is GVD_OK; otherwise
 * gvd_last_error() has one line for the user. Handles are opaque; each kind has a function that frees it and accepts
 * NULL. The caller owns arrays and gives them the length that the comment names; vertices and faces are row-major.
 * Indices are 0-based. Lengths are in the mesh's units. Strings are UTF-8 and end with a 0. Several threads may read a
 * handle at once. The same input gives the same results as the commands, to the last bit, for any number of threads.
 */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GVD_API __attribute__((visibility("default")))

/* The values are the exit codes of the commands, except GVD_OUT_OF_MEMORY, for which the commands end with 5. */
typedef enum gvd_status {
  GVD_OK = 0,
  GVD_OUT_OF_MEMORY = 1,
  GVD_INVALID_OPTION = 2,    /* an argument is out of range, or NULL although it must not be */
  GVD_UNREADABLE_INPUT = 3,  /* a file is missing, is no mesh, or is damaged */
  GVD_PRECONDITION = 4,      /* the input breaks a stated precondition */
  GVD_NO_VALID_RESULT = 5,   /* no valid result exists */
  GVD_UNWRITABLE_OUTPUT = 6, /* a file could not be written */
  GVD_INTERNAL_ERROR = 70,   /* a fault of the library */
  GVD_INTERRUPTED = 130      /* the progress callback or the flag `cancel` asked to stop */
} gvd_status;

/* The message of this thread's last failed call: what went wrong, where, and what to do. Valid until the next one. */
GVD_API const char* gvd_last_error(void);
/* The name of the error's code, such as "precondition". Empty for errors that input, options or results do not cause,
 * such as GVD_OUT_OF_MEMORY and GVD_INTERNAL_ERROR. */
GVD_API const char* gvd_last_error_code(void);
/* The 0-based index of the first offending element, or -1 if there is none. */
GVD_API int64_t gvd_last_error_element(void);
/* The version of the library, such as "0.2.0". */
GVD_API const char* gvd_version(void);

/* A mesh, a diagram, or the result of an operation. It never changes, and keeps everything alive from which it was
 * made. */
typedef struct gvd_object gvd_object;

/* How a call runs. NULL stands for all zeros. */
typedef struct gvd_run {
  int threads; /* 0: one for each core */
  /* Called by the calling thread with the name of a step and the fraction of the step that is done. Returning 0 cancels
   * the call. May be NULL. */
  int (*progress)(void* data, const char* step, double fraction);
  void* data; /* for `progress`, `note` and `iteration` */
  /* The call is cancelled when this is not 0. Any thread may set it. May be NULL. */
  const int32_t* cancel;
  /* Called by the calling thread with each line that users should not miss. May be NULL. */
  void (*note)(void* data, const char* text);
  /* If this is not NULL, `progress` is called only when it is not 0, and the call then sets it to 0. So a timer of the
   * caller can limit how often `progress` is called. */
  int32_t* due;
  int32_t door; /* how messages write options: one of the constants below */
  /* Called by the calling thread before the first iteration of lloyd and after each iteration, with the number of
   * iterations so far, the energy, and the generators: an object with the arrays points_faces and points_bary, which is
   * valid until the callback returns. May be NULL. */
  void (*iteration)(void* data, int32_t iterations, double energy, const gvd_object* points);
} gvd_run;

enum { GVD_JSON = 0, GVD_PYTHON = 1, GVD_JAVASCRIPT = 2 }; /* "count": 30, count=30, count: 30 */

/* ---- Objects, and operations on them ---- */

/* Releases an object. Objects may be released in any order. Accepts NULL. */
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

/* Numbers in memory that somebody else owns, in one or two dimensions. */
typedef struct gvd_array {
  const void* data;
  gvd_type type;
  int32_t dimensions; /* 1 or 2 */
  int64_t shape[2];
  int64_t strides[2]; /* bytes from one element to the next; may be negative */
} gvd_array;

/* The version of this interface. It changes when programs have to be compiled again. */
#define GVD_ABI 1

/* Runs an operation. gvd_describe() lists the operations with their options, and the kind of object that each takes.
 * `abi`: GVD_ABI. `on`: an object of this kind, or NULL for an operation that takes none, such as "mesh". `options`: a
 * JSON object such as {"count": 30, "density": {"array": 0}}, where {"array": 0} is the first of `arrays`; NULL for
 * none. Numbers may be strings, because JSON has no infinity. `arrays`: `count` arrays, which the call reads and does
 * not keep; NULL for none. */
GVD_API gvd_status gvd_call(int32_t abi, const char* operation, const gvd_object* on, const char* options,
                            const gvd_array* arrays, int32_t count, const gvd_run* run, gvd_object** result);
/* An array of an object, by its name in gvd_describe(). It lives as long as the object. An array that the object lacks
 * has length 0. Points are two arrays, NAME_faces and NAME_bary. Curves also have NAME_offsets, with the index of each
 * curve's first point and, at the end, the number of all points. */
GVD_API gvd_status gvd_array_of(const gvd_object* object, const char* name, gvd_array* view);
/* A part of an object, such as the diagram of a result, which has to be released separately. GVD_INVALID_OPTION if the
 * result was made without this part. */
GVD_API gvd_status gvd_object_of(const gvd_object* object, const char* name, gvd_object** part);
/* The figures of an object as JSON; for a result also its options and notes. The options can be passed to gvd_call
 * again, with the same arrays. The text lives as long as the object. */
GVD_API const char* gvd_figures(const gvd_object* object);
/* Writes an object as the command does with -o, in the format of the extension. GVD_INVALID_OPTION if this format would
 * lose results that the options asked for. */
GVD_API gvd_status gvd_write(const gvd_object* object, const char* path, const gvd_run* run);
/* The same with options such as {"ascii_ply": true}; NULL for none. gvd_describe() lists them as `file_options`. */
GVD_API gvd_status gvd_write_as(const gvd_object* object, const char* path, const char* options, const gvd_run* run);
/* Returns the bytes of such a file in memory, as an object with the array "bytes". `format`: an extension such as
 * "ply". */
GVD_API gvd_status gvd_file_of(const gvd_object* object, const char* format, const char* options, const gvd_run* run,
                               gvd_object** file);
/* Describes the operations with their options and results, the kinds of objects and the formats, as JSON. */
GVD_API const char* gvd_describe(void);
/* The same, with options spelled for a language, such as GVD_PYTHON. */
GVD_API const char* gvd_describe_for(int32_t door);

/* ---- Meshes ---- */

/* A mesh is an object of its own kind. */
typedef gvd_object gvd_mesh;

/* Reads a mesh file. If `repair` is not 0, defects are repaired if that loses no part of the surface. All other defects
 * are refused with GVD_PRECONDITION. */
GVD_API gvd_status gvd_mesh_read(const char* path, int repair, gvd_mesh** mesh);
/* Reads a mesh file as gvd_mesh_read does, and joins vertices at the same position, as is always done for an STL. With
 * a tolerance above 0 (mesh units), also joins vertices up to this distance apart, as --weld does. */
GVD_API gvd_status gvd_mesh_read_welded(const char* path, int repair, double tolerance, gvd_mesh** mesh);
/* Makes a mesh of `vertex_count` positions (3 numbers each) and `face_count` triangles (3 vertices each). */
GVD_API gvd_status gvd_mesh_create(const double* vertices, int64_t vertex_count, const int32_t* faces,
                                   int64_t face_count, int repair, gvd_mesh** mesh);
GVD_API void gvd_mesh_free(gvd_mesh* mesh);

/* The repairs that were made, one line each; empty if there were none. Valid as long as the mesh. */
GVD_API const char* gvd_mesh_repairs(const gvd_mesh* mesh);
GVD_API int32_t gvd_mesh_vertex_count(const gvd_mesh* mesh);
GVD_API int32_t gvd_mesh_face_count(const gvd_mesh* mesh);
/* Vertices of the mesh differ from the vertices of the file or of the arrays after repairs and welding. The input has
 * gvd_mesh_input_vertex_count vertices, and gvd_mesh_vertex_of_input returns the vertex of the mesh that an input
 * vertex became, or -1 if no face uses it. */
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

/* The point at a vertex of the file or of the arrays from which the mesh was made. */
GVD_API gvd_status gvd_point_at_vertex(const gvd_mesh* mesh, int64_t vertex, gvd_point* point);
/* The point of the surface nearest to a position, and its distance from the position; `distance` may be NULL. The first
 * call for a mesh builds a tree, in O(n log n). */
GVD_API gvd_status gvd_point_near(const gvd_mesh* mesh, const double position[3], gvd_point* point, double* distance);
GVD_API gvd_status gvd_point_position(const gvd_mesh* mesh, const gvd_point* point, double position[3]);

enum { GVD_FARTHEST = 0, GVD_RANDOM = 1, GVD_POISSON = 2, GVD_VERTICES = 3 };
typedef int32_t gvd_sampling; /* one of the constants above; any other number is GVD_INVALID_OPTION */

/* Spreads `count` points over the surface. points: count */
GVD_API gvd_status gvd_sample(const gvd_mesh* mesh, int32_t count, gvd_sampling kind, uint64_t seed, const gvd_run* run,
                              gvd_point* points);

/* ---- Exact distances and shortest paths ---- */

/* Distances of all vertices from the nearest source; infinity for a vertex that no source reaches. `nearest` gets the
 * nearest source, -1 for none, and may be NULL. Calls with one source each give a matrix row by row. distances,
 * nearest: vertex_count */
GVD_API gvd_status gvd_distances(const gvd_mesh* mesh, const gvd_point* sources, int32_t source_count,
                                 const gvd_run* run, double* distances, int32_t* nearest);

typedef struct gvd_path gvd_path;

/* Computes a shortest path from one point to another. GVD_NO_VALID_RESULT if they are in different components. */
GVD_API gvd_status gvd_path_compute(const gvd_mesh* mesh, const gvd_point* from, const gvd_point* to,
                                    const gvd_run* run, gvd_path** path);
GVD_API void gvd_path_free(gvd_path* path);
GVD_API double gvd_path_length(const gvd_path* path);
GVD_API int32_t gvd_path_point_count(const gvd_path* path);
/* The points of the path, including both ends. Consecutive points share a face. points: point_count */
GVD_API void gvd_path_points(const gvd_path* path, gvd_point* points);

/* ---- Voronoi diagrams and segmentations ---- */

/* A diagram is an object of its own kind. */
typedef gvd_object gvd_diagram;

enum { GVD_EXACT = 0, GVD_GBGVD = 1, GVD_PAPER = 2 };
typedef int32_t gvd_method; /* one of the constants above; any other number is GVD_INVALID_OPTION */

/* Computes the diagram of `count` generators. The mesh may be freed before the diagram. */
GVD_API gvd_status gvd_diagram_compute(const gvd_mesh* mesh, const gvd_point* generators, int32_t count,
                                       gvd_method method, const gvd_run* run, gvd_diagram** diagram);
GVD_API void gvd_diagram_free(gvd_diagram* diagram);

/* The nearest generator of every vertex, -1 for none, and its distance. Either may be NULL. vertex_count each */
GVD_API void gvd_diagram_vertices(const gvd_diagram* diagram, int32_t* labels, double* distances);
/* The area of every cell. areas: count */
GVD_API void gvd_diagram_areas(const gvd_diagram* diagram, double* areas);

GVD_API int32_t gvd_diagram_branch_point_count(const gvd_diagram* diagram);
/* The points where three or more cells meet, and their distances from the generators; `distances` may be NULL.
 * branch_point_count each */
GVD_API void gvd_diagram_branch_points(const gvd_diagram* diagram, gvd_point* points, double* distances);

typedef struct gvd_bisector {
  int32_t left, right; /* the cells on both sides along the points, seen from outside */
  int32_t ends[2];     /* its branch points; -1 for an end on the mesh's boundary and for a closed bisector */
  int32_t closed;      /* 1: the first point follows the last */
  int32_t point_count;
} gvd_bisector;

GVD_API int32_t gvd_diagram_bisector_count(const gvd_diagram* diagram);
GVD_API gvd_status gvd_diagram_bisector(const gvd_diagram* diagram, int32_t index, gvd_bisector* bisector);
/* points: point_count of the bisector */
GVD_API gvd_status gvd_diagram_bisector_points(const gvd_diagram* diagram, int32_t index, gvd_point* points);

/* Labels every face with a generator, or -1 for none, as gvd-segment does. The faces of each label are connected.
 * Borders are smooth if `smooth` is not 0. labels: face_count */
GVD_API gvd_status gvd_segment(const gvd_diagram* diagram, int smooth, const gvd_run* run, int32_t* labels);
/* Writes the same file as gvd-segment -o, with smooth borders, in the format of the extension. */
GVD_API gvd_status gvd_segment_write(const gvd_diagram* diagram, const char* path, const gvd_run* run);

/* ---- Relaxation ---- */

typedef struct gvd_lloyd_options {
  int32_t iterations;  /* the largest number; below 0: the default */
  double tolerance;    /* as --tolerance; below 0: the default */
  double crease_angle; /* keep generators on edges sharper than this, degrees; 0: none */
  int32_t keep_boundary;
  gvd_sampling sampling; /* of the initial generators, if none are given */
  uint64_t seed;
} gvd_lloyd_options;

GVD_API void gvd_lloyd_defaults(gvd_lloyd_options* options);
/* Moves `count` generators to the centroids of their cells, as gvd-lloyd does. `given`: the initial generators; NULL:
 * they are sampled. `options` may be NULL. `energy` is in mesh units to the fourth power, and may be NULL. relaxed:
 * count */
GVD_API gvd_status gvd_lloyd(const gvd_mesh* mesh, const gvd_point* given, int32_t count,
                             const gvd_lloyd_options* options, const gvd_run* run, gvd_point* relaxed, double* energy);

/* ---- Remeshes ---- */

typedef struct gvd_remesh_options {
  int32_t relaxation;     /* iterations; below 0: the default */
  int32_t exact_count;    /* exactly `count` vertices, or GVD_NO_VALID_RESULT */
  double crease_angle;    /* degrees; 0: no creases; below 0: the creases that `count` generators can follow */
  int32_t loose_boundary; /* put no generators on the boundary */
  gvd_sampling sampling;
  uint64_t seed;
} gvd_remesh_options;

GVD_API void gvd_remesh_defaults(gvd_remesh_options* options);
/* Makes the coarse mesh that is dual to the diagram of `count` generators and of the generators that are added, as
 * gvd-remesh does. `given` and `options`: as for gvd_lloyd. */
GVD_API gvd_status gvd_remesh(const gvd_mesh* mesh, const gvd_point* given, int32_t count,
                              const gvd_remesh_options* options, const gvd_run* run, gvd_mesh** coarse);
/* The generator of every vertex of a remesh, as a point of the mesh from which the remesh was made. GVD_INVALID_OPTION
 * for a mesh that gvd_remesh has not made. points: vertex_count */
GVD_API gvd_status gvd_mesh_generators(const gvd_mesh* coarse, gvd_point* points);

#ifdef __cplusplus
}
#endif

#endif
