"""Calls from Python: no leak, other threads go on, Ctrl-C ends a run, and progress is told."""
import gc
import importlib.util
import os
import resource
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy

import gvd
import meshes

# What a process may grow by in 1,000 calls, bytes. A mesh and a diagram of the grid take 40 kB: a leak of one a call is
# 40 MB. Measured without a leak: below 1 MB.
LEAK = 8 << 20


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as statm:
        return int(statm.read().split()[1]) * resource.getpagesize()


class Calls(unittest.TestCase):
    def test_a_thousand_calls_leak_nothing(self):
        vertices, faces = meshes.make_grid(8)

        def call():
            mesh = gvd.Mesh(vertices, faces)
            diagram = mesh.voronoi([0, 30, 60, 80], threads=1)
            kept = diagram.labels, diagram.bisectors, diagram.branch_points, diagram.cells, diagram.segment().labels
            mesh.distances([0, 1], each=True, threads=1), mesh.path(0, 80), diagram.cut().mesh, kept
            for wrong in ("text", -1, 10**6):
                try:
                    mesh.distances(wrong)
                except gvd.Error:
                    pass

        for _ in range(200):
            call()
        gc.collect()
        before = resident_bytes()
        for _ in range(1000):
            call()
        gc.collect()
        self.assertLess(resident_bytes() - before, LEAK)

    def test_two_threads_at_once_give_what_each_gives_alone(self):
        mesh = gvd.read(meshes.FIGURE)
        alone = [mesh.voronoi([0, 100 + i]).distances.copy() for i in range(8)]
        found, errors = {}, []

        def work(which):
            try:
                for i in which:
                    found[i] = mesh.voronoi([0, 100 + i]).distances.copy()
            except Exception as error:  # told below
                errors.append(error)

        threads = [threading.Thread(target=work, args=(range(k, 8, 2),)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(errors, [])
        for i in range(8):
            numpy.testing.assert_array_equal(found[i], alone[i])

    def test_other_threads_run_during_a_call(self):
        mesh = gvd.read(meshes.FIGURE)
        done, turns = threading.Event(), 0

        def work():
            for _ in range(3):
                mesh.distances(list(range(60)), each=True, threads=1)
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.is_set():
            turns += 1
            time.sleep(0.001)
        thread.join()
        self.assertGreater(turns, 20)

    def test_control_c_ends_a_run(self):
        # With a distance for each vertex it takes minutes.
        code = ("import gvd, sys\n"
                f"mesh = gvd.read({str(meshes.FIGURE)!r})\n"
                "print('begins', flush=True)\n"
                "try:\n"
                "    for _ in range(100): mesh.distances(list(range(len(mesh.vertices))), each=True)\n"
                "except KeyboardInterrupt:\n"
                "    print('interrupted', len(mesh.distances(0)), flush=True)\n")
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline().strip(), "begins")
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        started = time.monotonic()
        out, _ = process.communicate(timeout=60)
        self.assertEqual(out.strip(), f"interrupted {len(gvd.read(meshes.FIGURE).vertices)}")
        self.assertLess(time.monotonic() - started, 20)
        self.assertEqual(process.returncode, 0)

    def test_progress_is_told_and_can_end_a_call(self):
        mesh = gvd.read(meshes.FIGURE)
        told = []

        def note(step, fraction):
            told.append((step, fraction))

        mesh.distances(list(range(300)), each=True, progress=note)
        self.assertGreater(len(told), 1)
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction in told))
        self.assertEqual([f for _, f in told], sorted(f for _, f in told))
        for false in (False, numpy.False_):
            with self.assertRaises(gvd.Error) as caught:
                mesh.distances(list(range(2000)), each=True, progress=lambda step, fraction: false)
            self.assertEqual(caught.exception.code, "interrupted")

        def fail(step, fraction):
            raise ZeroDivisionError(step)

        with self.assertRaises(ZeroDivisionError):
            mesh.distances(list(range(2000)), each=True, progress=fail)

    def test_an_error_tells_of_a_name_that_is_no_unicode(self):
        with self.assertRaisesRegex(gvd.Error, "no such file") as caught:
            gvd.read(b"/no/\xff.obj")
        self.assertIn(os.fsdecode(b"/no/\xff.obj"), str(caught.exception))

    def run_with_bar(self, first):
        code = f"{first}\nimport gvd\ngvd.read({str(meshes.FIGURE)!r}).distances(list(range(300)), each=True, progress=True)\n"
        ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertIn("distances", ran.stderr)
        self.assertEqual(ran.stdout, "")

    def test_a_bar_needs_no_package(self):
        self.run_with_bar("import sys; sys.modules['tqdm'] = sys.modules['tqdm.auto'] = None")

    @unittest.skipIf(importlib.util.find_spec("tqdm") is None, "tqdm is not installed (python3-tqdm)")
    def test_a_bar_of_tqdm(self):
        self.run_with_bar("import tqdm")


if __name__ == "__main__":
    os.chdir(meshes.ROOT)
    unittest.main()
