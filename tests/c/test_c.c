/* The C interface from C: distances on known surfaces, the parts of a diagram, refusals, cancelled runs, handles. */
#include <gvd/gvd.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                                     \
  do {                                                                                       \
    if (!(condition)) {                                                                      \
      ++failures;                                                                            \
      fprintf(stderr, "%s:%d: %s [%s]\n", __FILE__, __LINE__, #condition, gvd_last_error()); \
    }                                                                                        \
  } while (0)
#define REQUIRE(condition)     \
  do {                         \
    CHECK(condition);          \
    if (failures > 0) exit(1); \
  } while (0)

/* A unit square of two triangles, and a third triangle apart. */
static const double kSquare[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0};
static const int32_t kFaces[] = {0, 1, 2, 0, 2, 3, 4, 5, 6};

static gvd_mesh* make_square(void) {
  gvd_mesh* mesh = NULL;
  REQUIRE(gvd_mesh_create(kSquare, 7, kFaces, 3, 0, &mesh) == GVD_OK);
  return mesh;
}

static void test_mesh(void) {
  gvd_mesh* mesh = make_square();
  double vertices[21];
  int32_t faces[9];
  CHECK(gvd_mesh_vertex_count(mesh) == 7 && gvd_mesh_face_count(mesh) == 3);
  gvd_mesh_vertices(mesh, vertices);
  gvd_mesh_faces(mesh, faces);
  CHECK(memcmp(vertices, kSquare, sizeof kSquare) == 0);
  CHECK(memcmp(faces, kFaces, sizeof kFaces) == 0);
  CHECK(strcmp(gvd_mesh_repairs(mesh), "") == 0);
  gvd_mesh_free(mesh);
  gvd_mesh_free(NULL);

  /* A flipped face is repaired where that is asked for. */
  const int32_t flipped[] = {0, 1, 2, 0, 3, 2};
  CHECK(gvd_mesh_create(kSquare, 4, flipped, 2, 0, &mesh) == GVD_PRECONDITION);
  REQUIRE(gvd_mesh_create(kSquare, 4, flipped, 2, 1, &mesh) == GVD_OK);
  CHECK(strstr(gvd_mesh_repairs(mesh), "orient") != NULL);
  gvd_mesh_free(mesh);

  /* Vertex 0 is in no face and goes: distances are those of the others, and tell which ones by the input's numbers. */
  const int32_t without_first[] = {1, 2, 3};
  gvd_point source;
  double distances[3];
  REQUIRE(gvd_mesh_create(kSquare, 4, without_first, 1, 1, &mesh) == GVD_OK);
  CHECK(gvd_mesh_vertex_count(mesh) == 3 && gvd_mesh_input_vertex_count(mesh) == 4);
  CHECK(gvd_mesh_vertex_of_input(mesh, 0) == -1 && gvd_mesh_vertex_of_input(mesh, 4) == -1);
  CHECK(gvd_point_at_vertex(mesh, 1, &source) == GVD_OK);
  CHECK(gvd_distances(mesh, &source, 1, NULL, distances, NULL) == GVD_OK);
  CHECK(distances[gvd_mesh_vertex_of_input(mesh, 1)] == 0);
  CHECK(distances[gvd_mesh_vertex_of_input(mesh, 2)] == 1);
  gvd_mesh_free(mesh);
}

static void test_distances(void) {
  gvd_mesh* mesh = make_square();
  gvd_point source, target, inner = {0, {0.2, 0.3, 0.5}};
  double distances[7], position[3];
  int32_t nearest[7];
  CHECK(gvd_point_at_vertex(mesh, 1, &source) == GVD_OK);
  CHECK(gvd_distances(mesh, &source, 1, NULL, distances, nearest) == GVD_OK);
  CHECK(distances[1] == 0 && fabs(distances[3] - sqrt(2)) < 1e-14 && distances[0] == 1);
  CHECK(isinf(distances[5]) && nearest[5] == -1 && nearest[3] == 0);
  CHECK(gvd_distances(mesh, &source, 1, NULL, distances, NULL) == GVD_OK);

  const double query[] = {0.25, 0.75, 3};
  double away = 0;
  CHECK(gvd_point_near(mesh, query, &target, &away) == GVD_OK);
  CHECK(away == 3 && target.face == 1);
  CHECK(gvd_point_position(mesh, &target, position) == GVD_OK);
  CHECK(fabs(position[0] - 0.25) < 1e-15 && fabs(position[1] - 0.75) < 1e-15 && position[2] == 0);

  gvd_path* path = NULL;
  REQUIRE(gvd_path_compute(mesh, &inner, &target, NULL, &path) == GVD_OK);
  CHECK(gvd_point_position(mesh, &inner, position) == GVD_OK);
  CHECK(fabs(gvd_path_length(path) - hypot(position[0] - 0.25, position[1] - 0.75)) < 1e-14);
  const int32_t count = gvd_path_point_count(path);
  gvd_point* points = malloc(sizeof(gvd_point) * (size_t)count);
  gvd_path_points(path, points);
  CHECK(count >= 2 && memcmp(&points[0].bary, &inner.bary, sizeof inner.bary) == 0);
  free(points);
  gvd_path_free(path);
  gvd_point_at_vertex(mesh, 5, &source);
  CHECK(gvd_path_compute(mesh, &inner, &source, NULL, &path) == GVD_NO_VALID_RESULT);
  CHECK(strstr(gvd_last_error(), "components") != NULL);
  gvd_mesh_free(mesh);
}

static int count_calls(void* data, const char* step, double fraction) {
  ++*(int*)data;
  return step != NULL && fraction >= 0 && fraction <= 1;
}
static int cancel(void* data, const char* step, double fraction) {
  (void)data, (void)step, (void)fraction;
  return 0;
}

static void test_diagram(const char* file) {
  gvd_mesh* mesh = NULL;
  gvd_diagram* diagram = NULL;
  gvd_point generators[20];
  int calls = 0;
  const gvd_run counted = {1, count_calls, &calls, NULL, NULL, NULL, GVD_JSON, NULL}, cancelled = {0, cancel, NULL, NULL, NULL, NULL, GVD_JSON, NULL};
  REQUIRE(gvd_mesh_read(file, 1, &mesh) == GVD_OK);
  CHECK(gvd_sample(mesh, 20, GVD_FARTHEST, 0, NULL, generators) == GVD_OK);
  CHECK(gvd_diagram_compute(mesh, generators, 20, GVD_EXACT, &cancelled, &diagram) == GVD_INTERRUPTED);
  CHECK(diagram == NULL);
  REQUIRE(gvd_diagram_compute(mesh, generators, 20, GVD_EXACT, &counted, &diagram) == GVD_OK);
  CHECK(calls > 0);
  const int32_t vertices = gvd_mesh_vertex_count(mesh), faces = gvd_mesh_face_count(mesh);
  gvd_mesh_free(mesh); /* the diagram needs it no more */

  int32_t *labels = malloc(sizeof(int32_t) * (size_t)(faces > vertices ? faces : vertices)), owned[20] = {0};
  double areas[20], sum = 0;
  gvd_diagram_vertices(diagram, labels, NULL);
  for (int32_t v = 0; v < vertices; ++v) CHECK(labels[v] >= 0 && labels[v] < 20);
  CHECK(gvd_segment(diagram, 1, NULL, labels) == GVD_OK);
  for (int32_t f = 0; f < faces; ++f) ++owned[labels[f]];
  gvd_diagram_areas(diagram, areas);
  for (int i = 0; i < 20; ++i) {
    sum += areas[i];
    CHECK(owned[i] > 0);
  }
  CHECK(sum > 0);

  const int32_t bisectors = gvd_diagram_bisector_count(diagram), branches = gvd_diagram_branch_point_count(diagram);
  CHECK(bisectors > 20 && branches > 20);
  gvd_bisector bisector;
  REQUIRE(gvd_diagram_bisector(diagram, bisectors - 1, &bisector) == GVD_OK);
  CHECK(bisector.left != bisector.right && bisector.ends[0] < branches && bisector.point_count >= 2);
  gvd_point* points = malloc(sizeof(gvd_point) * (size_t)bisector.point_count);
  CHECK(gvd_diagram_bisector_points(diagram, bisectors - 1, points) == GVD_OK);
  CHECK(points[0].face >= 0 && points[0].face < faces);
  CHECK(gvd_diagram_bisector(diagram, bisectors, &bisector) == GVD_INVALID_OPTION);
  gvd_point* branch_points = malloc(sizeof(gvd_point) * (size_t)branches);
  double* distances = malloc(sizeof(double) * (size_t)branches);
  gvd_diagram_branch_points(diagram, branch_points, distances);
  CHECK(distances[0] > 0);
  free(labels), free(points), free(branch_points), free(distances);
  gvd_diagram_free(diagram);
}

static void test_refusals(void) {
  gvd_mesh* mesh = make_square();
  gvd_diagram* diagram = NULL;
  gvd_point point = {99, {1, 0, 0}}, twice[2] = {{0, {1, 0, 0}}, {0, {1, 0, 0}}};
  double distances[7];
  CHECK(gvd_distances(mesh, &point, 1, NULL, distances, NULL) == GVD_PRECONDITION);
  CHECK(strstr(gvd_last_error(), "99") != NULL);
  point.face = 0, point.bary[0] = 2;
  CHECK(gvd_distances(mesh, &point, 1, NULL, distances, NULL) == GVD_PRECONDITION);
  /* The element is the place of the point in its list, whatever its face is. */
  for (int32_t face = 1; face < 8; face += 6) {
    gvd_point second[2] = {{0, {1, 0, 0}}, {face, {2, 0, 0}}};
    CHECK(gvd_distances(mesh, second, 2, NULL, distances, NULL) == GVD_PRECONDITION);
    CHECK(gvd_last_error_element() == 1);
  }
  CHECK(gvd_distances(mesh, NULL, 1, NULL, distances, NULL) == GVD_INVALID_OPTION);
  CHECK(gvd_distances(mesh, twice, 0, NULL, distances, NULL) == GVD_INVALID_OPTION);
  CHECK(gvd_diagram_compute(mesh, twice, 2, GVD_EXACT, NULL, &diagram) == GVD_PRECONDITION);
  CHECK(gvd_diagram_compute(mesh, twice, 1, 7, NULL, &diagram) == GVD_INVALID_OPTION);
  CHECK(gvd_diagram_compute(NULL, twice, 1, GVD_EXACT, NULL, &diagram) == GVD_INVALID_OPTION);
  CHECK(gvd_point_at_vertex(mesh, 7, &point) == GVD_PRECONDITION);
  gvd_lloyd_options options;
  gvd_lloyd_defaults(&options);
  options.keep_boundary = 1;
  gvd_point relaxed[2];
  CHECK(gvd_lloyd(mesh, twice, 2, &options, NULL, relaxed, NULL) == GVD_PRECONDITION);
  CHECK(strstr(gvd_last_error(), "coincide") != NULL);
  options.crease_angle = NAN;
  CHECK(gvd_lloyd(mesh, twice, 1, &options, NULL, relaxed, NULL) == GVD_INVALID_OPTION);
  gvd_lloyd_defaults(&options);
  options.tolerance = NAN;
  CHECK(gvd_lloyd(mesh, twice, 1, &options, NULL, relaxed, NULL) == GVD_INVALID_OPTION);
  CHECK(gvd_mesh_generators(mesh, &point) == GVD_INVALID_OPTION);
  CHECK(gvd_mesh_write(mesh, "mesh.unknown") == GVD_INVALID_OPTION);
  CHECK(gvd_mesh_write(mesh, "/no/such/folder/mesh.ply") == GVD_UNWRITABLE_OUTPUT);
  CHECK(gvd_mesh_write(mesh, "") == GVD_INVALID_OPTION);
  CHECK(strcmp(gvd_last_error(), "path is empty; name a file") == 0);
  CHECK(gvd_mesh_read("", 1, &mesh) == GVD_INVALID_OPTION);
  CHECK(strcmp(gvd_last_error(), "path is empty; name a file") == 0);
  CHECK(gvd_mesh_read("/no/such/file.obj", 1, &mesh) == GVD_UNREADABLE_INPUT);
  const double bad[] = {0, 0, 0, 1, 0, 0, 0, NAN, 0};
  const int32_t outside[] = {0, 1, 3}, face[] = {0, 1, 2};
  gvd_mesh* none = NULL;
  CHECK(gvd_mesh_create(bad, 3, face, 1, 1, &none) == GVD_PRECONDITION);
  CHECK(gvd_mesh_create(kSquare, 3, outside, 1, 1, &none) == GVD_PRECONDITION);
  CHECK(gvd_mesh_create(kSquare, 3, face, 0, 1, &none) == GVD_PRECONDITION);
  CHECK(strcmp(gvd_last_error(), "the mesh has no face; give it at least one") == 0);
  CHECK(none == NULL);
  gvd_mesh_free(mesh);
}

/* Operations by name, with options as JSON and arrays. */
static void test_calls(const char* file) {
  gvd_object *mesh = NULL, *relaxed = NULL, *diagram = NULL;
  const int64_t vertices[] = {3, 17, 99};
  const gvd_array list = {vertices, GVD_INT64, 1, {3, 1}, {sizeof(int64_t), 0}};
  gvd_array faces, bary;
  REQUIRE(gvd_mesh_read(file, 1, &mesh) == GVD_OK);
  REQUIRE(gvd_call(GVD_ABI, "lloyd", mesh, "{\"vertices\": {\"array\": 0}, \"iterations\": 2}", &list, 1, NULL,
                   &relaxed) == GVD_OK);
  gvd_release(mesh); /* results keep what they need */
  REQUIRE(gvd_array_of(relaxed, "generators_faces", &faces) == GVD_OK);
  REQUIRE(gvd_array_of(relaxed, "generators_bary", &bary) == GVD_OK);
  CHECK(faces.type == GVD_INT32 && faces.dimensions == 1 && faces.shape[0] == 3);
  CHECK(bary.type == GVD_FLOAT64 && bary.dimensions == 2 && bary.shape[0] == 3 && bary.shape[1] == 3);
  for (int64_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (int64_t j = 0; j < 3; ++j) {
      sum += *(const double*)((const char*)bary.data + i * bary.strides[0] + j * bary.strides[1]);
    }
    CHECK(fabs(sum - 1) < 1e-12);
  }
  CHECK(strstr(gvd_figures(relaxed), "\"iterations\":2") != NULL);
  REQUIRE(gvd_object_of(relaxed, "diagram", &diagram) == GVD_OK);
  gvd_release(relaxed);
  REQUIRE(gvd_array_of(diagram, "vertex_labels", &faces) == GVD_OK);
  CHECK(faces.shape[0] > 0 && *(const int32_t*)faces.data >= 0);
  gvd_release(diagram);
  CHECK(gvd_call(GVD_ABI, "lloyd", NULL, "{}", NULL, 0, NULL, &relaxed) == GVD_INVALID_OPTION);
  CHECK(strstr(gvd_describe(), "\"remesh\"") != NULL);
  CHECK(strcmp(gvd_figures(NULL), "null") == 0);
}

int main(int argc, char** argv) {
  char file[1024];
  if (argc != 2) return 2;
  snprintf(file, sizeof file, "%s/figure.obj", argv[1]);
  test_mesh();
  test_distances();
  test_diagram(file);
  test_refusals();
  test_calls(file);
  if (failures == 0) printf("all checks of version %s passed\n", gvd_version());
  return failures > 0;
}
