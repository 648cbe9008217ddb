"""Files are those of the commands, byte by byte. GVD_BIN names the folder of the commands."""
import html
import json
import os
import pathlib
import pickle
import subprocess
import tempfile
import unittest
import warnings

import numpy

import gvd
import meshes

BIN = pathlib.Path(os.environ.get("GVD_BIN", meshes.ROOT / "build" / "bin")).resolve()


class SameBytes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        warnings.simplefilter("ignore", UserWarning)  # plate.stl is welded

    def run_command(self, name, *arguments):
        subprocess.run([BIN / name, "-q", *map(str, arguments)], check=True, cwd=self.folder)

    def assert_same_files(self, result, stem, extensions, **options):
        for extension in extensions:
            ours = self.folder / f"ours.{extension}"
            result.to_file(ours, **options)
            with self.subTest(extension):
                theirs = (self.folder / f"{stem}.{extension}").read_bytes()
                self.assertEqual(ours.read_bytes().replace(b"ours.mtl", f"{stem}.mtl".encode()), theirs)

    def test_segment(self):
        extensions = ["ply", "obj", "off", "coff", "stl", "vtp", "vtu", "glb", "json"]
        outputs = [part for e in extensions for part in ("-o", f"a.{e}")]
        for mesh_file, n in ((meshes.FIGURE, 30), (meshes.TORUS, 7), (meshes.HALF_SPHERE, 12), (meshes.PLATE, 5)):
            self.run_command("gvd-segment", mesh_file, "-n", n, *outputs, "--diagram", "diagram.json")
            regions = gvd.read(mesh_file).segment(n)
            self.assert_same_files(regions, "a", extensions)
            self.assert_same_files(regions.diagram, "diagram", ["json"])
            self.run_command("gvd-segment", mesh_file, "-n", n, "--cut", *outputs)
            self.assert_same_files(regions.diagram.cut(), "a", extensions)

    def test_texture_coordinates_and_materials(self):
        square = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\nusemtl red\nf 1/1 2/2 3/3\n"
        (self.folder / "t.obj").write_text(square + "usemtl blue\nf 1/5 3/3 4/4\n")
        mesh = gvd.read(self.folder / "t.obj")
        numpy.testing.assert_array_equal(mesh.texture_coordinates, [[[0, 0], [1, 0], [1, 1]], [[5, 5], [1, 1], [0, 1]]])
        numpy.testing.assert_array_equal(pickle.loads(pickle.dumps(mesh)).texture_coordinates, mesh.texture_coordinates)
        self.assertIsNone(gvd.read(meshes.TORUS).texture_coordinates)
        extensions = ["ply", "obj", "glb"]
        outputs = [part for e in extensions for part in ("-o", f"a.{e}")]
        regions = mesh.segment(generators=[0, 2])
        self.run_command("gvd-segment", "t.obj", "--vertices", "0,2", *outputs)
        self.assert_same_files(regions, "a", extensions)
        self.run_command("gvd-segment", "t.obj", "--vertices", "0,2", "--region-materials", "-o", "b.obj")
        self.assert_same_files(regions, "b", ["obj"], region_materials=True)
        self.run_command("gvd-segment", "t.obj", "--vertices", "0,2", "--cut", *outputs)
        cut = regions.diagram.cut()
        self.assert_same_files(cut, "a", extensions)
        self.assertEqual(cut.mesh.texture_coordinates.shape, (len(cut.mesh.faces), 3, 2))
        cut.mesh.to_file(self.folder / "plain.obj")
        self.assertIn("usemtl blue", (self.folder / "plain.obj").read_text())
        outputs = [part for e in extensions for part in ("-o", f"uv.{e}")]
        self.run_command("gvd-segment", "t.obj", "--vertices", "0,2", "--uv", "flat", *outputs)
        charts = regions.diagram.cut(uv="flat")
        self.assert_same_files(charts, "uv", extensions)
        charts.to_file(self.folder / "charts.obj")
        self.assertIn("usemtl region_1", (self.folder / "charts.obj").read_text())

    def test_properties(self):
        self.run_command("gvd-segment", meshes.FIGURE, "-n", 30, "-o", "p.ply")
        regions = gvd.read(meshes.FIGURE).segment(30)
        properties = gvd.read_properties(self.folder / "p.ply")
        numpy.testing.assert_array_equal(properties["face"]["label"], regions.labels)
        numpy.testing.assert_array_equal(properties["vertex"]["distance"], numpy.float32(regions.diagram.distances))
        self.assertEqual(list(properties["face"]), ["label", "red", "green", "blue", "intensity"])
        self.assertEqual(gvd.read_properties(meshes.FIGURE), {"vertex": {}, "face": {}})
        with self.assertRaisesRegex(gvd.Error, "none.ply"):
            gvd.read_properties("none.ply")

    def test_charts(self):
        extensions = ["obj", "ply", "glb"]
        outputs = [part for e in extensions for part in ("-o", f"c.{e}")]
        self.run_command("gvd-segment", meshes.FIGURE, "-n", 30, "--uv", "logmap", *outputs, "--report", "c.json")
        diagram = gvd.read(meshes.FIGURE).segment(30).diagram
        cut = diagram.cut(uv="logmap")
        self.assert_same_files(cut, "c", extensions)
        told = json.loads((self.folder / "c.json").read_text())["results"]["charts"]
        self.assertEqual(cut.scale, told["scale"])
        self.assertEqual([(c.label, c.faces, c.area, c.stretch, [*c.box[0], *c.box[1]], list(c.origin)) for c in cut.charts],
                         [(c["label"], c["faces"], c["area"], c["stretch"], c["box"], c["origin"]) for c in told["charts"]])
        self.assertEqual(diagram.cut().charts, [])
        torus = gvd.read(meshes.TORUS)
        with self.assertRaisesRegex(gvd.Error, "is not a disc"):
            torus.segment(2).diagram.cut(uv="flat")
        self.run_command("gvd-segment", meshes.TORUS, "-n", 2, "--disc", "--uv", "flat", *outputs)
        self.assert_same_files(torus.segment(2, disc=True).diagram.cut(uv="flat"), "c", extensions)
        self.run_command("gvd-segment", meshes.TORUS, "--levels", "2,4", "--disc", "-o", "d.json")
        self.assert_same_files(torus.segment(levels=[2, 4], disc=True), "d", ["json"])

    def test_formats_of_brains(self):
        extensions = ["surf.gii", "label.gii", "shape.gii", "fs", "annot", "curv"]
        outputs = [part for e in extensions for part in ("-o", f"a.{e}")]
        self.run_command("gvd-segment", meshes.FIGURE, "-n", 30, *outputs)
        regions = gvd.read(meshes.FIGURE).segment(30)
        self.assert_same_files(regions, "a", extensions)
        for name in ("a.label.gii", "a.annot"):
            numpy.testing.assert_array_equal(gvd.read_values(self.folder / name), regions.diagram.labels + 1)
        for name in ("a.shape.gii", "a.curv"):
            numpy.testing.assert_array_equal(gvd.read_values(self.folder / name), numpy.float32(regions.diagram.distances))
        for name, input_format in (("a.surf.gii", "gii"), ("a.fs", "fs")):
            numpy.testing.assert_array_equal(gvd.read(self.folder / name, input_format=input_format).faces, regions.diagram.mesh.faces)
        with self.assertRaisesRegex(gvd.Error, "b.label.gii: the extension must be one of .ply, .obj,"):
            regions.diagram.mesh.to_file(self.folder / "b.label.gii")

    def test_options(self):
        self.run_command("gvd-segment", meshes.FIGURE, "-n", 9, "--sampling", "poisson", "--seed", 5, "--method", "gbgvd",
                         "--front", "planar", "--labels", "nearest", "--ascii-ply", "--no-curves", "-o", "b.ply", "-o", "b.vtp")
        regions = gvd.read(meshes.FIGURE).segment(9, sampling="poisson", seed=5, method="gbgvd", front="planar",
                                                  labels="nearest")
        self.assert_same_files(regions, "b", ["ply"], ascii_ply=True)
        self.assert_same_files(regions, "b", ["vtp"], no_curves=True)
        self.run_command("gvd-segment", meshes.FIGURE, "-n", 11, "--method", "paper", "-o", "k.json")
        self.assert_same_files(gvd.read(meshes.FIGURE).segment(11, method="paper"), "k", ["json"])
        self.run_command("gvd-segment", meshes.TORUS, "--radius", 0.5, "-o", "c.json")
        self.assert_same_files(gvd.read(meshes.TORUS).segment(radius=0.5), "c", ["json"])
        self.run_command("gvd-segment", meshes.TORUS, "--vertices", "3,17,99", "-o", "d.json")
        self.assert_same_files(gvd.read(meshes.TORUS).segment(generators=[3, 17, 99]), "d", ["json"])
        positions = [(1.0, 0.5, 0.0), (-1.0, 0.25, 0.125)]
        (self.folder / "list.txt").write_text("".join("p {} {} {}\n".format(*p) for p in positions))
        self.run_command("gvd-segment", meshes.TORUS, "--generators", "list.txt", "-o", "e.json")
        self.assert_same_files(gvd.read(meshes.TORUS).segment(generators=positions), "e", ["json"])

    def test_segment_inside_regions(self):
        extensions = ["ply", "obj", "off", "stl", "vtp", "vtu", "glb", "json"]
        outputs = [part for e in extensions for part in ("-o", f"w.{e}")]
        for mesh_file in (meshes.FIGURE, meshes.HALF_SPHERE, meshes.PLATE):
            mesh = gvd.read(mesh_file)
            within = mesh.segment(4).labels * 10 - 10  # the first one is left out
            mask = numpy.arange(len(mesh.faces)) % 50 == 0
            (self.folder / "within.txt").write_text("\n".join(map(str, within)))
            (self.folder / "mask.txt").write_text("\n".join(str(int(m)) for m in mask))
            given = ["--within", "within.txt", "--mask", "mask.txt"]
            self.run_command("gvd-segment", mesh_file, "-n", 90, *given, *outputs, "--diagram", "diagram.json")
            regions = mesh.segment(90, within=within, mask=mask)
            self.assert_same_files(regions, "w", extensions)
            self.assert_same_files(regions.diagram, "diagram", ["json"])
            self.assertEqual(regions.diagram.check(), [])
            self.assertEqual(regions.diagram.distances.shape, (len(mesh.vertices),))
            left_out = mask | (within < 0)
            numpy.testing.assert_array_equal(regions.regions, within)
            numpy.testing.assert_array_equal(regions.labels < 0, left_out)
            for label in range(regions.labels.max() + 1):
                self.assertLessEqual(len(set(within[regions.labels == label])), 1)
            self.run_command("gvd-segment", mesh_file, "-n", 90, *given, "--cut", *outputs)
            self.assert_same_files(regions.diagram.cut(), "w", extensions)

    def test_segment_levels(self):
        outputs = ["-o", "v.ply", "-o", "v.vtp", "-o", "v.json"]
        for mesh_file in (meshes.FIGURE, meshes.PLATE):
            self.run_command("gvd-segment", mesh_file, "--levels", "3,10,60", "--labels", "nearest", *outputs, "--face-labels", "v.npy")
            regions = gvd.read(mesh_file).segment(levels=[3, 10, 60], labels="nearest")
            self.assert_same_files(regions, "v", ["ply", "vtp", "json"])
            numpy.testing.assert_array_equal(numpy.load(self.folder / "v.npy"), numpy.stack(regions.levels, axis=1))
            numpy.testing.assert_array_equal(regions.levels[-1], regions.labels)
            for coarse, fine in zip(regions.levels, regions.levels[1:]):
                pairs = set(zip(fine.tolist(), coarse.tolist()))
                self.assertEqual(len(pairs), len({label for label, _ in pairs}))
            self.run_command("gvd-segment", mesh_file, "--levels", "3,60", "--cut", *outputs)
            self.assert_same_files(gvd.read(mesh_file).segment(levels=[3, 60]).diagram.cut(), "v", ["ply", "vtp", "json"])
        torus = gvd.read(meshes.TORUS)
        halves = (torus.vertices[:, 0] > 0).astype(int)  # of vertices
        (self.folder / "halves.txt").write_text("\n".join(map(str, halves)))
        self.run_command("gvd-segment", meshes.TORUS, "--per-region", 3, "--within", "halves.txt", "-o", "x.json")
        self.assert_same_files(torus.segment(per_region=3, within=halves), "x", ["json"])
        inside = numpy.flatnonzero(halves == 0)[[5, 9, 60]]
        self.run_command("gvd-segment", meshes.TORUS, "--vertices", ",".join(map(str, inside)), "--mask", "halves.txt", "-o", "y.json")
        self.assert_same_files(torus.segment(generators=inside, mask=halves), "y", ["json"])
        for wrong in ({"count": 5, "within": [1, 2]}, {"per_region": 2}, {"levels": [5, 3]}, {"levels": [2], "count": 3}, {"levels": []},
                      {"per_region": 1.5, "within": halves}, {"levels": "five"}):
            with self.subTest(wrong), self.assertRaises(gvd.Error) as caught:
                torus.segment(**wrong)
            self.assertEqual(caught.exception.code, "invalid_option")
        for wrong in ({"count": 1, "within": halves}, {"count": 5, "within": halves + 0.5}, {"count": 5, "mask": halves * 0 + 1},
                      {"count": 5, "mask": halves * numpy.nan}):
            with self.subTest(wrong), self.assertRaises(gvd.Error) as caught:
                torus.segment(**wrong)
            self.assertEqual(caught.exception.code, "precondition")

    def test_lloyd(self):
        extensions = ["txt", "csv", "json", "ply", "vtp"]
        outputs = [part for e in extensions for part in ("-o", f"l.{e}")]
        for mesh_file, n in ((meshes.FIGURE, 30), (meshes.PLATE, 12)):
            self.run_command("gvd-lloyd", mesh_file, "-n", n, *outputs, "--points", "points.npy")
            samples = gvd.read(mesh_file).lloyd(n)
            self.assert_same_files(samples, "l", extensions)
            samples.points_to_file(self.folder / "ours.npy")
            self.assertEqual((self.folder / "ours.npy").read_bytes(), (self.folder / "points.npy").read_bytes())
            self.assertTrue((numpy.diff(samples.energies) < 0).all())
            columns = numpy.load(self.folder / "points.npy")
            numpy.testing.assert_array_equal(columns[:, 10:12].T, [samples.areas, samples.cell_energies])
        given = ["--iterations", 7, "--accelerate", "none", "--features", 30, "--keep-boundary", "--seed", 2,
                 "--density", "curvature", "--gradation", 0.5, "--relocate", "on"]
        self.run_command("gvd-lloyd", meshes.PLATE, "-n", 40, *given, "-o", "m.json")
        samples = gvd.read(meshes.PLATE).lloyd(40, iterations=7, accelerate="none", features=30, keep_boundary=True, seed=2,
                                               density="curvature", gradation=0.5, relocate=True)
        self.assert_same_files(samples, "m", ["json"])
        weights = 1 + numpy.arange(len(gvd.read(meshes.TORUS).vertices)) % 5
        (self.folder / "weights.txt").write_text("\n".join(map(str, weights)))
        (self.folder / "fixed.txt").write_text("7\n100\n")
        self.run_command("gvd-lloyd", meshes.TORUS, "-n", 20, "--density", "weights.txt", "--fixed", "fixed.txt", "-o", "n.json")
        self.assert_same_files(gvd.read(meshes.TORUS).lloyd(20, density=weights, fixed=[7, 100]), "n", ["json"])

    def test_remesh(self):
        extensions = ["ply", "obj", "off", "stl", "vtp", "vtu", "glb", "json"]
        outputs = [part for e in extensions for part in ("-o", f"r.{e}")]
        for mesh_file, n in ((meshes.TORUS, 150), (meshes.PLATE, 120)):
            self.run_command("gvd-remesh", mesh_file, "-n", n, *outputs, "--map", "map.json", "--view", "r.html")
            coarse = gvd.read(mesh_file).remesh(n)
            self.assert_same_files(coarse, "r", extensions)
            self.assert_same_files(coarse, "r", ["html"], title=f"gvd-remesh: {mesh_file.name}")
            coarse.map().to_file(self.folder / "ours.json")
            self.assertEqual((self.folder / "ours.json").read_bytes(), (self.folder / "map.json").read_bytes())
            self.assertEqual(len(coarse.diagram.cells), len(coarse.mesh.vertices))
        torus = gvd.read(meshes.TORUS)
        self.run_command("gvd-remesh", meshes.TORUS, "--target-edge", 0.4, "--place", "fit", "--shape", 0.8, "--relax", 5,
                         "--features", "none", "--coarse", "off", "-o", "s.json")
        self.assert_same_files(torus.remesh(target_edge=0.4, place="fit", shape=0.8, relax=5, features="none", coarse="off"),
                               "s", ["json"])
        self.run_command("gvd-remesh", meshes.TORUS, "--error", 0.05, "--loose-boundary", "-o", "t.json")
        self.assert_same_files(torus.remesh(error=0.05, loose_boundary=True), "t", ["json"])
        points = torus.farthest(90)
        self.run_command("gvd-lloyd", meshes.TORUS, "-n", 90, "--iterations", 0, "-o", "list.txt")
        self.run_command("gvd-remesh", meshes.TORUS, "--generators", "list.txt", "--exact-count", "-o", "u.json")
        self.assert_same_files(torus.remesh(generators=points, exact_count=True), "u", ["json"])
        map_back = torus.remesh(200).map()
        self.assertTrue(map_back.one_to_one)
        self.assertEqual((len(map_back.points.face), map_back.points.bary.shape[1]), (len(torus.vertices), 3))
        for wrong in ({"count": 100, "error": 1.0}, {"target_edge": 0.0}, {"count": 100, "place": "best"}, {"count": 100, "relax": "five"},
                      {"count": 100, "features": "some"}, {"count": 100, "density": "red"}, {"count": 100, "density": [1.0, 2.0]},
                      {"count": 2.5}, {"count": 100, "max_added": -1}, {"count": 100, "seed": -1}, {"count": 100, "shape": 2.0}):
            with self.subTest(wrong), self.assertRaises(gvd.Error) as caught:
                torus.remesh(**wrong)
            self.assertEqual(caught.exception.code, "invalid_option")

    def test_extensions_in_capitals(self):
        regions = gvd.read(meshes.TORUS).segment(6)
        for extension in ("json", "ply", "html"):
            regions.to_file(self.folder / f"c.{extension}")
            regions.to_file(self.folder / f"C.{extension.upper()}")
            self.assertEqual((self.folder / f"C.{extension.upper()}").read_bytes(),
                             (self.folder / f"c.{extension}").read_bytes())

    def test_page(self):
        self.run_command("gvd-segment", meshes.FIGURE, "-n", 6, "-o", "f.ply", "--view", "f.html")
        regions = gvd.read(meshes.FIGURE).segment(6)
        self.assert_same_files(regions, "f", ["html"], title="gvd-segment: figure.obj")
        shown = regions._repr_html_()
        self.assertTrue(shown.startswith("<iframe srcdoc="))
        self.assertEqual(html.unescape(shown[len('<iframe srcdoc="'):shown.index('" style=')]), regions.to_html())
        self.assertIn("<html", gvd.read(meshes.TORUS).to_html()[:300])
        self.assertIn("<html", regions.diagram.to_html()[:300])

    def test_meshes_come_back(self):
        mesh = gvd.read(meshes.TORUS)
        for extension in ("ply", "obj", "off", "vtp", "vtu"):
            mesh.to_file(self.folder / f"g.{extension}")
            again = gvd.read(self.folder / f"g.{extension}", input_format=extension)
            numpy.testing.assert_array_equal(again.vertices, mesh.vertices)
            numpy.testing.assert_array_equal(again.faces, mesh.faces)
        with self.assertRaises(gvd.Error) as caught:
            mesh.to_file(self.folder / "g.xyz")
        self.assertEqual(caught.exception.code, "invalid_option")
        with self.assertRaises(gvd.Error) as caught:
            mesh.to_file(self.folder / "none" / "g.ply")
        self.assertEqual(caught.exception.code, "unwritable_output")

    def test_paths_are_written(self):
        path = gvd.read(meshes.TORUS).path(0, 300)
        for extension in ("npy", "csv", "obj"):
            path.to_file(self.folder / f"p.{extension}")
        numpy.testing.assert_array_equal(numpy.load(self.folder / "p.npy"), path.positions)
        numpy.testing.assert_array_equal(numpy.loadtxt(self.folder / "p.csv", delimiter=",", skiprows=1)[:, 8:11], path.positions)
        self.run_command("gvd-distance", meshes.TORUS, "--from", 300, "--to", 0, "--paths", "-o", self.folder / "theirs.csv")
        self.assertEqual((self.folder / "p.csv").read_bytes(), (self.folder / "theirs.csv").read_bytes())
        self.assertEqual((self.folder / "p.obj").read_text().count("v "), len(path.positions))
        path.to_file(self.folder / "P.CSV")
        self.assertEqual((self.folder / "P.CSV").read_bytes(), (self.folder / "p.csv").read_bytes())
        gvd.read(meshes.TORUS).path(7, 7).to_file(os.fsencode(self.folder / "o.obj"))  # a line needs two points
        with self.assertRaises(gvd.Error) as caught:
            gvd.read(meshes.TORUS).path(7, 8).to_file(self.folder / "none" / "p.csv")
        self.assertEqual(caught.exception.code, "unwritable_output")
        self.assertEqual(list(self.folder.glob("**/*.part")), [])
        self.assertRegex((self.folder / "o.obj").read_text(), r"^v [^\n]*\n$")


try:
    import vtkmodules.vtkCommonDataModel as vtk
except ImportError:
    vtk = None


@unittest.skipIf(vtk is None, "VTK for Python is not installed (python3-vtk9)")
class Vtk(unittest.TestCase):
    def test_polydata_hold_the_arrays(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        mesh = gvd.read(meshes.TORUS)
        regions = mesh.segment(8)
        surface = regions.to_vtk()
        self.assertEqual((surface.GetNumberOfPoints(), surface.GetNumberOfPolys()), (len(mesh.vertices), len(mesh.faces)))
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetPoints().GetData()), mesh.vertices)
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3), mesh.faces)
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetCellData().GetArray("Label")), regions.labels)
        numpy.testing.assert_array_equal(vtk_to_numpy(surface.GetPointData().GetArray("Distance")), regions.diagram.distances)
        lines = regions.diagram.bisectors_to_vtk()
        bisectors = regions.diagram.bisectors
        self.assertEqual(lines.GetNumberOfLines(), len(bisectors))
        self.assertEqual(lines.GetNumberOfPoints(), sum(len(b.positions) + b.closed for b in bisectors))
        self.assertEqual(mesh.path(0, 9).to_vtk().GetNumberOfLines(), 1)
        self.assertEqual(regions.diagram.cut().to_vtk().GetCellData().GetArray("Parent").GetNumberOfTuples(),
                         len(regions.diagram.cut().labels))


if __name__ == "__main__":
    unittest.main()
