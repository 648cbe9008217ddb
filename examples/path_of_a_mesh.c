/* The shortest path between two vertices of a mesh, by the C interface.
 *
 *   path_of_a_mesh MESH FROM TO
 */
#include <gvd/gvd.h>
#include <stdio.h>
#include <stdlib.h>

/* Ends the program with the library's message where a call has failed. */
static void check(gvd_status status) {
  if (status == GVD_OK) return;
  fprintf(stderr, "path_of_a_mesh: error: %s\n", gvd_last_error());
  exit((int)status);
}

int main(int argc, char** argv) {
  if (argc != 4) {
    fprintf(stderr, "usage: path_of_a_mesh MESH FROM TO\n");
    return 2;
  }
  gvd_mesh* mesh = NULL;
  gvd_point from, to;
  gvd_path* path = NULL;
  check(gvd_mesh_read(argv[1], 1, &mesh));
  check(gvd_point_at_vertex(mesh, atoll(argv[2]), &from));
  check(gvd_point_at_vertex(mesh, atoll(argv[3]), &to));
  check(gvd_path_compute(mesh, &from, &to, NULL, &path));

  const int32_t count = gvd_path_point_count(path);
  gvd_point* points = malloc(sizeof(gvd_point) * (size_t)count);
  gvd_path_points(path, points);
  printf("length %.17g\n", gvd_path_length(path));
  for (int32_t i = 0; i < count; ++i) {
    double p[3];
    check(gvd_point_position(mesh, &points[i], p));
    printf("%.17g %.17g %.17g\n", p[0], p[1], p[2]);
  }
  free(points);
  gvd_path_free(path);
  gvd_mesh_free(mesh);
  return 0;
}
