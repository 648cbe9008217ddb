"""Hooks of mkdocs (mkdocs.yml). They let pages that are written for the repository work on the site.

- Links that leave docs/ lead to copies on the site, below repository/. Those to sources lead to extra.source_url if that is given.
- A ```sh block that a ```python block follows becomes two tabs. Bars in code in tables are written as in the repository.
- FOLDER/* in the navigation stands for the pages below a folder that the navigation does not name.
- Doxygen writes the API reference.
- The search also works where no server is.
- After the build, every link of the site is followed. Nothing may come from the network.
"""
import html
import html.parser
import json
import os
import pathlib
import posixpath
import re
import shutil
import subprocess
import textwrap
import urllib.parse

from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
FENCE = re.compile(r"^```.*?^```$|`[^`\n]+`", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"(?<=\]\()(?P<markdown>[^)\s#]+)|(?<=src=\")(?P<html>[^\"]+)")
TABS = re.compile(r"^```sh\n(?P<sh>.*?)^```\n\n```python\n(?P<python>.*?)^```\n", re.MULTILINE | re.DOTALL)
BARS = re.compile(r"`[^`\n]*\\\|[^`\n]*`")
EXTERNAL = re.compile(r"[a-z][a-z0-9+.-]*:|//")


def uri_of(path):
    """Where the site has a file of the repository. Sources are text, which every browser shows."""
    if DOCS in path.parents:
        return path.relative_to(DOCS).as_posix()
    return f"repository/{path.relative_to(ROOT).as_posix()}" + ("" if path.suffix in (".md", ".webp", ".svg") else ".txt")


def is_elsewhere(path, config):
    """Whether a link to a file leads to the repository's own site."""
    return bool(config["extra"]["source_url"]) and DOCS not in path.parents and path.suffix != ".md"


def replace_links(text, replace):
    """The text with REPLACE(match) for each link outside of code."""
    parts, end = [], 0
    for code in FENCE.finditer(text):
        parts += [LINK.sub(replace, text[end:code.start()]), code.group()]
        end = code.end()
    return "".join([*parts, LINK.sub(replace, text[end:])])


def target_of(page, link):
    """The file that a link of a page of the repository means, or None."""
    if EXTERNAL.match(link):
        return None
    target = (page.parent / urllib.parse.unquote(link)).resolve()
    return target / "README.md" if target.is_dir() else target


def make_reference(folder):
    """Writes the API reference to a folder. Returns its files."""
    shutil.rmtree(folder, ignore_errors=True)
    settings = (ROOT / "scripts/site/Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {folder.parent}\nHTML_OUTPUT = {folder.name}\n"
    ran = subprocess.run(["doxygen", "-"], cwd=ROOT, input=settings, text=True, stderr=subprocess.PIPE)
    if ran.returncode != 0:
        raise PluginError(f"doxygen: {ran.stderr}")
    return [path for path in folder.rglob("*") if path.is_file()]


def list_folder(folder, page):
    """Writes a page with the names of a folder's files, for a folder without a README."""
    names = sorted(path.name for path in folder.iterdir() if not path.name.startswith(("_", ".")))
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text("\n".join([f"# {folder.name}", "", "The files of this folder:", "", *(f"- `{name}`" for name in names), ""]))
    return page


def on_files(files, config):
    """Adds the API reference and the files outside docs/ that pages lead to, and completes the navigation."""
    def add(uri, path):
        files.append(File(uri, str(ROOT), config["site_dir"], config["use_directory_urls"]))
        files.get_file_from_path(uri).abs_src_path = str(path)

    reference = pathlib.Path(config["site_dir"]).with_name("api")
    for path in make_reference(reference):
        add("api/" + path.relative_to(reference).as_posix(), path)
    pages = [pathlib.Path(file.abs_src_path) for file in files if file.is_documentation_page()]
    while pages:
        page = pages.pop()
        links = [link.group() for link in LINK.finditer(FENCE.sub("", page.read_text()))]
        for target in filter(None, (target_of(page, link) for link in links)):
            uri = uri_of(target)
            if files.get_file_from_path(uri) is not None or is_elsewhere(target, config):
                continue
            if target.is_file():
                add(uri, target)
                pages += [target] if target.suffix == ".md" else []
            elif target.name == "README.md" and target.parent.is_dir():
                add(uri, list_folder(target.parent, reference.with_name("lists") / uri))
            else:
                raise PluginError(f"{page.relative_to(ROOT)} leads to {target}, which is not there")
    named = set(re.findall(r"'([^']+\.md)'", str(config["nav"])))
    config["nav"] = complete(config["nav"], sorted(file.src_uri for file in files if file.src_uri not in named))
    return files


def complete(nav, others):
    """The navigation, with the pages among OTHERS that FOLDER/* stands for."""
    result = []
    for entry in nav:
        if isinstance(entry, dict):
            result += [{title: complete(part, others) if isinstance(part, list) else part} for title, part in entry.items()]
        elif entry.endswith("/*"):
            result += [uri for uri in others if uri.endswith(".md") and uri.startswith(entry[:-1])]
        else:
            result.append(entry)
    return result


def on_page_markdown(markdown, page, config, files):
    source = pathlib.Path(page.file.abs_src_path)

    def replace(link):
        target = target_of(source, link.group())
        if target is None:
            return link.group()
        if is_elsewhere(target, config):
            return f"{config['extra']['source_url']}/{target.relative_to(ROOT).as_posix()}"
        return posixpath.relpath(uri_of(target), posixpath.dirname(page.file.src_uri))

    def tabs(match):
        return "".join(f'=== "{title}"\n\n' + textwrap.indent(f"```{kind}\n{match[kind]}```\n\n", "    ")
                       for kind, title in (("sh", "Command"), ("python", "Python")))

    def bars(match):
        return "<code>" + html.escape(match.group().strip("`")).replace("\\|", "&#124;") + "</code>"

    return BARS.sub(bars, TABS.sub(tabs, replace_links(markdown, replace)))


class Links(html.parser.HTMLParser):
    """The links of a page, the resources that it loads, and the anchors that it has."""

    def __init__(self, text):
        super().__init__()
        self.links, self.resources, self.anchors = set(), set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors.update(filter(None, (given.get("id"), given.get("name"))))
        loads = tag == "link" and given.get("rel") != "canonical" or "src" in given
        (self.resources if loads else self.links).update(filter(None, (given.get("src"), given.get("href"))))


def check_site(site):
    """The findings in the pages of a site: dead links, and resources of other sites."""
    own = (path for path in site.rglob("*.html") if site / "api" not in path.parents)  # Doxygen checks its own
    pages = {path: Links(path.read_text()) for path in own if path.name != "404.html"}  # which has absolute links
    findings = []
    for path, page in pages.items():
        findings += [f"{path.relative_to(site)} loads {link}" for link in page.resources if re.match("https?:|//", link)]
        for link in (link for link in page.links | page.resources if not EXTERNAL.match(link)):
            to, _, anchor = urllib.parse.unquote(link).partition("#")
            target = pathlib.Path(os.path.normpath(path.parent / to)) if to else path
            target = target / "index.html" if target.is_dir() else target
            if not target.is_file() or anchor and target in pages and anchor not in pages[target].anchors:
                findings.append(f"{path.relative_to(site)} has the dead link {link}")
    return sorted(findings)


def on_post_page(output, page, config):
    """Without a server, browsers refuse to fetch the index of the search and its worker: both then come from a script."""
    script = posixpath.relpath("search/local.js", posixpath.dirname(page.url))
    local = f"""<script>location.protocol === "file:" && document.write('<script src="{script}"><\\/script>')</script>\n"""
    return re.sub(r'(?=<script src="[^"]*/bundle\.)', lambda _: local, output, count=1)


def on_post_build(config):
    site = pathlib.Path(config["site_dir"])
    worker, = site.glob("assets/javascripts/workers/search.*.min.js")
    (site / "search/local.js").write_text(
        f"window.__search = {{index: Promise.resolve({(site / 'search/search_index.json').read_text()}),"
        f" worker: URL.createObjectURL(new Blob([{json.dumps(worker.read_text())}]))}};\n")
    findings = check_site(site)
    if findings:
        raise PluginError("\n".join(findings))
