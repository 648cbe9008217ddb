"""Calls from Python: no leak, other threads go on, Ctrl-C ends a run, and progress is told."""
import gc
import importlib.util
import itertools
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


def in_thread(run):
    """Runs it in another thread, and raises what it raises."""
    raised = []

    def work():
        try:
            run()
        except BaseException as error:
            raised.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    for error in raised:
        raise error


class Calls(unittest.TestCase):
    def test_a_thousand_calls_leak_nothing(self):
        vertices, faces = meshes.make_grid(8)

        def call():
            mesh = gvd.Mesh(vertices, faces)
            diagram = mesh.voronoi([0, 30, 60, 80], threads=1)
            kept = diagram.labels, diagram.bisectors, diagram.branch_points, list(diagram.cells), diagram.segment().labels
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

    def test_ten_thousand_calls_leak_nothing(self):
        mesh = gvd.Mesh(*meshes.make_box(1, 2, 3))
        diagram = mesh.voronoi([0, 6])

        def call():
            made = diagram.segment()
            return made.labels, made.figures, made.diagram.cells.area

        for _ in range(1000):
            call()
        gc.collect()
        before = resident_bytes()
        for _ in range(10000):
            call()
        gc.collect()
        self.assertLess(resident_bytes() - before, LEAK)

    def test_objects_go_in_any_order(self):
        for order in itertools.permutations(range(4)):
            mesh = gvd.Mesh(*meshes.make_box(1, 2, 3))
            regions = mesh.segment(3)
            parts = [mesh, regions, regions.diagram, regions.diagram.cut().mesh]
            arrays = [parts[0].vertices, parts[1].labels, parts[2].distances, parts[3].faces]
            copies = [array.copy() for array in arrays]
            del mesh, regions
            for i in order:
                parts[i] = None
                gc.collect()
                for array, copy in zip(arrays, copies):
                    numpy.testing.assert_array_equal(array, copy)

    def test_arrays_are_the_library_s_own_memory(self):
        mesh = gvd.read(meshes.FIGURE)
        labels = [mesh.voronoi([0, 9]).labels for _ in range(2)]
        self.assertNotEqual(*(array.__array_interface__["data"][0] for array in labels))
        native = mesh._native
        places = {native.array("vertex_positions").__array_interface__["data"] for _ in range(2)} | {mesh.vertices.__array_interface__["data"]}
        self.assertEqual(len(places), 1)
        self.assertTrue(places.pop()[1], "read only")

    def end_by_control_c(self, call):
        """What a process prints that is interrupted in the middle of a call, and the seconds until it has ended."""
        code = ("import gvd, signal, sys\n"
                "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # which a job in the background ignores
                f"mesh = gvd.read({str(meshes.FIGURE)!r})\n"
                "print('begins', flush=True)\n"
                "try:\n"
                f"    for _ in range(100): {call}\n"
                "except KeyboardInterrupt:\n"
                "    print('interrupted', len(mesh.distances(0)), flush=True)\n")
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline().strip(), "begins")
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        started = time.monotonic()
        out, told = process.communicate(timeout=60)
        self.assertEqual((out.strip(), process.returncode), (f"interrupted {len(gvd.read(meshes.FIGURE).vertices)}", 0), told)
        return time.monotonic() - started, told

    def test_control_c_ends_any_call_within_two_seconds(self):
        # Each takes minutes.
        for call in ("mesh.distances(list(range(len(mesh.vertices))), each=True)", "mesh.lloyd(2000, iterations=100000, tolerance=0.0)",
                     "mesh.remesh(1500, relax=100000)", "mesh.path(list(range(len(mesh.vertices))), 0)"):
            for progress in ("", ", progress=lambda step, done: None"):
                with self.subTest(call, progress=progress):
                    for _ in range(3):  # the machine may be busy with something else
                        seconds, told = self.end_by_control_c(call[:-1] + progress + ")")
                        self.assertEqual(told, "")
                        if seconds < 2:
                            break
                    self.assertLess(seconds, 2)

    def test_a_handler_of_the_user_s_sees_control_c(self):
        seen = []
        before = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
        try:
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(gvd.Error) as caught:
                gvd.read(meshes.FIGURE).lloyd(2000, iterations=100000, tolerance=0.0)
            self.assertEqual((caught.exception.code, seen), ("interrupted", [signal.SIGINT]))
            self.assertEqual(signal.getsignal(signal.SIGINT).__name__, "<lambda>")
        finally:
            signal.signal(signal.SIGINT, before)

    def test_what_a_handler_raises_while_objects_go_is_raised(self):
        mesh, lost, caught = gvd.read(meshes.TORUS), [], 0

        def make_and_drop_objects():
            while True:
                held = [gvd._handles.Handle(None) for _ in range(10)]
                made = mesh.points([0, 5]), held
                del held, made

        # Raises below that function only: on a slow machine, signals also come while this test counts or puts the handler back.
        def alarm(number, frame):
            while frame:
                if frame.f_code is make_and_drop_objects.__code__:
                    raise TimeoutError
                frame = frame.f_back

        before, hook, sys.unraisablehook = signal.signal(signal.SIGALRM, alarm), sys.unraisablehook, lost.append
        try:
            signal.setitimer(signal.ITIMER_REAL, 1e-3, 1e-3)
            while caught < 200:
                with self.assertRaises(TimeoutError):
                    make_and_drop_objects()
                caught += 1
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
            sys.unraisablehook = hook
        self.assertEqual(lost, [], "in a destructor")

    def test_objects_are_released_as_they_go(self):
        released = []
        release, gvd._library.library.gvd_release = gvd._library.library.gvd_release, lambda one: released.append(one._as_parameter_)
        try:
            handles = [gvd._handles.Handle(address) for address in range(1, 1001)]
            cycle = [handles.pop()]
            cycle.append(cycle)
            del handles, cycle
            gc.collect()
        finally:
            gvd._library.library.gvd_release = release
        self.assertEqual(sorted(released), list(range(1, 1001)))

    def test_what_a_handler_of_any_signal_raises_ends_a_call(self):
        def alarm(number, frame):
            raise TimeoutError("alarm")

        mesh = gvd.read(meshes.FIGURE)
        before = signal.signal(signal.SIGALRM, alarm)
        try:
            for progress in (None, lambda step, done: None):
                signal.setitimer(signal.ITIMER_REAL, 0.3)
                with self.assertRaisesRegex(TimeoutError, "alarm"):
                    mesh.lloyd(2000, iterations=100000, tolerance=0.0, progress=progress)
            self.assertIs(signal.getsignal(signal.SIGALRM), alarm)
            seen = []
            signal.signal(signal.SIGALRM, lambda number, frame: seen.append(number))  # raises nothing: the call goes on
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            self.assertEqual(len(mesh.lloyd(200, iterations=20).generators), 200)
            signal.setitimer(signal.ITIMER_REAL, 0)
            self.assertEqual(seen, [signal.SIGALRM])
        finally:
            signal.signal(signal.SIGALRM, before)

    def test_a_name_with_a_nul_is_refused_and_a_message_is_one_line(self):
        mesh = gvd.Mesh(*meshes.make_box(1, 2, 3))
        for call in (lambda: mesh.to_file("a.ply\0.obj"), lambda: gvd.read("a.ply\0junk")):
            with self.assertRaisesRegex(gvd.Error, "a name of a file has no NUL in it"):
                call()
        self.assertFalse(os.path.exists("a.ply"))
        with self.assertRaisesRegex(gvd.Error, r"^no\?such\?\[31m\.ply: there is no such file$"):
            gvd.read("no\nsuch\x1b[31m.ply")

    def test_a_time_limit_ends_a_call(self):
        mesh = gvd.read(meshes.FIGURE)
        work = [lambda: mesh.lloyd(2000, iterations=100000, tolerance=0.0, time_limit=0.3)]
        for where in (lambda run: run(), lambda run: in_thread(run)):
            started = time.monotonic()
            with self.assertRaisesRegex(gvd.Error, "the time limit of 0.3 s is over") as caught:
                where(work[0])
            self.assertEqual(caught.exception.code, "interrupted")
            self.assertLess(time.monotonic() - started, 2)
        for long in (100, numpy.inf, 1e300):
            self.assertEqual(len(mesh.lloyd(5, time_limit=long).generators), 5)
        for wrong in (0, -1, numpy.nan, "1", True):
            with self.assertRaisesRegex(gvd.Error, "^time_limit: a number (of seconds above 0 )?is needed, not "):
                mesh.lloyd(5, time_limit=wrong)

    def test_a_time_limit_may_be_short(self):
        mesh = gvd.read(meshes.FIGURE)
        for _ in range(5):  # the machine may be busy with something else
            started = time.monotonic()
            with self.assertRaisesRegex(gvd.Error, "the time limit of 0.01 s is over"):
                mesh.lloyd(2000, iterations=100000, tolerance=0.0, time_limit=0.01)
            seconds = time.monotonic() - started
            if seconds < 0.1:  # the clock ticks each 0.1 s
                break
        self.assertLess(seconds, 0.1)

    def test_a_time_limit_is_that_of_all_rows(self):
        mesh = gvd.read(meshes.FIGURE)
        started = time.monotonic()
        with self.assertRaisesRegex(gvd.Error, "the time limit of 0.2 s is over"):
            mesh.distances(list(range(len(mesh.vertices))), each=True, time_limit=0.2)  # takes seconds, in parts below 0.2 s
        self.assertLess(time.monotonic() - started, 2)

    def test_python_ends_while_daemon_threads_compute(self):
        code = ("import gvd, threading, time\n"
                f"mesh = gvd.read({str(meshes.FIGURE)!r})\n"
                "def work(): mesh.lloyd(2000, iterations=100000, tolerance=0.0, progress=lambda step, done: None)\n"
                "for _ in range(4): threading.Thread(target=work, daemon=True).start()\n"
                "time.sleep(0.5)\n")
        for _ in range(5):
            ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
            self.assertEqual((ran.returncode, ran.stderr), (0, ""))

    def test_a_wrong_keyword_gets_the_function_s_name_and_what_was_meant(self):
        mesh = gvd.Mesh(*meshes.make_box(1, 2, 3))
        for call, words in ((lambda: mesh.segment(3, lables="smooth"), "Mesh.segment has no option 'lables'; did you mean 'labels'?"),
                            (lambda: mesh.remesh(3, exact=True), "Mesh.remesh has no option 'exact'; did you mean 'exact_count'?"),
                            (lambda: mesh.voronoi([0, 1], qqq=1), "Mesh.voronoi has no option 'qqq'"),
                            (lambda: mesh.to_file("a.ply", ascii=True), "Writable.to_file has no option 'ascii'; did you mean 'ascii_ply'?")):
            with self.assertRaises(TypeError) as caught:
                call()
            self.assertEqual(str(caught.exception), words)

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
