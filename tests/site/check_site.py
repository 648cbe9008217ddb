#!/usr/bin/python3
"""The site builds without a warning, and its checks find what they are for. Needs Debian's mkdocs and Doxygen: 77 without them.

    tests/site/check_site.py SITE_FOLDER BIN_FOLDER
"""
import pathlib
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SITE, BIN = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(ROOT / "scripts/site"))


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        ran = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--site-dir", SITE], cwd=ROOT, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if ran.returncode != 0:
            raise AssertionError(ran.stdout)

    def read(self, name):
        return (SITE / name).read_text()

    def test_commands_and_python_are_side_by_side(self):
        page = self.read("guide/tasks/measure.html")
        self.assertIn('class="tabbed-set', page)
        self.assertIn("gvd-distance", page)

    def test_links_that_leave_the_documents_lead_to_copies(self):
        self.assertIn('href="../repository/libgvd/include/gvd/exact_field.hpp.txt"', self.read("guide/accuracy.html"))
        self.assertEqual(self.read("repository/libgvd/include/gvd/exact_field.hpp.txt"),
                         (ROOT / "libgvd/include/gvd/exact_field.hpp").read_text())

    def test_bars_in_tables_of_options_have_no_backslash(self):
        self.assertIn("<code>--method exact|gbgvd|paper</code>", self.read("guide/commands.html").replace("&#124;", "|"))

    def test_the_search_needs_no_server(self):
        page = self.read("guide/tasks/measure.html")
        self.assertLess(page.index("../../search/local.js"), page.index("bundle."))
        script = self.read("search/local.js")
        self.assertIn("gvd-distance", script)
        self.assertIn("lunr", script)

    def test_the_reference_has_the_libraries(self):
        reference = self.read("api/namespacegvd.html")
        for name in ("compute_diagram", "segment_faces", "relax_generators", "remesh_surface"):
            self.assertIn(name, reference)

    def test_dead_links_anchors_and_other_sites_are_found(self):
        from hooks import check_site
        page = SITE / "guide/glossary.html"
        text = page.read_text()
        self.assertEqual(check_site(SITE), [])
        for bad in ('<a href="nothing.html">', '<a href="commands.html#nothing">', '<a href="#nothing">',
                    '<img src="../pictures/nothing.webp">', '<script src="https://example.org/a.js"></script>',
                    '<link rel="stylesheet" href="//example.org/a.css">'):
            page.write_text(text + bad)
            self.assertEqual(len(check_site(SITE)), 1, bad)
        page.write_text(text)


class Examples(unittest.TestCase):
    def check(self, text):
        page = SITE.with_name("site-page.md")
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(text)
        return subprocess.run([ROOT / "scripts/check_examples.py", BIN, page], stdout=subprocess.DEVNULL).returncode

    def test_what_works_passes(self):
        self.assertEqual(self.check("    build/bin/gvd-segment data/figure.obj -n 3 -o a.ply\n\n```sh\ngvd-segment a.ply -n 3\n```\n"), 0)
        self.assertEqual(self.check("    build/bin/gvd-segment data/figure.obj -n none   # fails\n"), 0)
        self.assertEqual(self.check("    source <(build/bin/gvd-segment --print-completion bash)\n"), 0)

    def test_what_does_not_do_what_it_says_fails(self):
        for text in ("    build/bin/gvd-segment data/nothing.obj -n 3\n", "    build/bin/gvd-segment --version   # fails\n",
                     "    n=$(build/bin/gvd-segment data/nothing.obj -n 3)\n", "    true && build/bin/gvd-segment data/nothing.obj -n 3\n",
                     "```sh\nfalse\ntrue\n```\n"):
            self.assertEqual(self.check(text), 1, text)

    def test_python_lines_of_a_page_are_one_script(self):
        if not (BIN.parent / "python/gvd").is_dir():
            self.skipTest("the Python package is not built")
        self.assertEqual(self.check("```python\nx = 1\n```\n\n```python\nimport gvd\nassert x == 1\n```\n"), 0)
        self.assertEqual(self.check("```python\nassert False\n```\n"), 1)


if __name__ == "__main__":
    if not shutil.which("mkdocs") or not shutil.which("doxygen"):
        print("mkdocs or doxygen is missing: scripts/install-deps.sh site")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
