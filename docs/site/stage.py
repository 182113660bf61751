# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Gathers what the site shows in one folder for Sphinx.

The pages stay the Markdown that a forge shows. Here they are copied, and their links to files of the
repository become links to pages of the site: of documents to their page, of headers to the
reference, of other files to a page with their text.

usage: stage.py FOLDER [BUILD]    BUILD: folder of a build whose examples are run
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path, PurePosixPath

import reference

REPOSITORY = Path(__file__).resolve().parents[2]
LANGUAGES = {".cpp": "cpp", ".h": "cpp", ".yaml": "yaml", ".cff": "yaml", ".py": "python", ".json": "json"}

# Pages at the root of the repository; docs/X.md becomes X.
ROOT_PAGES = {
    "README.md": "readme.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
    "SECURITY.md": "security.md",
    "docs/README.md": "map.md",
    "docs/site/index.md": "index.md",
    "examples": "examples.md",
    "include/vandplan": "cpp/index.rst",
}

# What examples look like that draw no picture themselves.
PICTURES = {
    "01_first_plan": (
        "docs/images/drive.png",
        "The same yard, planned with wheels that are turned while it rolls, and what a simulated truck drove",
    ),
    "03_weights": ("docs/images/driver.png", "What a driver minds, in scenario 7 of the thesis"),
    "05_steering": ("docs/images/steering.png", "Shortest paths on open ground"),
    "06_nearest_and_tables": ("docs/images/table-accuracy.png", "How far off looked up lengths are"),
    "16_rig": ("docs/images/dock.png", "The same dock, planned by the command line"),
}


def fail(message):
    sys.exit(f"scripts/docs: {message}")


class Site:
    """The folder that Sphinx reads, and which file of the repository became which page of it."""

    def __init__(self, folder):
        self.folder = folder
        self.written = set()
        self.faults = []
        self.pages = dict(ROOT_PAGES)
        for page in (REPOSITORY / "docs").rglob("*.md"):
            name = page.relative_to(REPOSITORY).as_posix()
            if not name.startswith("docs/site/"):
                self.pages.setdefault(name, name.removeprefix("docs/"))
        for header in (REPOSITORY / "include/vandplan").glob("*.h"):
            self.pages[f"include/vandplan/{header.name}"] = f"cpp/{header.stem}.rst"

    def write(self, name, content):
        """Writes a file unless it is there already: Sphinx reads again what is newer."""
        file = self.folder / name
        data = content.encode() if isinstance(content, str) else content
        file.parent.mkdir(parents=True, exist_ok=True)
        if not file.exists() or file.read_bytes() != data:
            file.write_bytes(data)
        self.written.add(file)

    def remove_others(self):
        for file in self.folder.rglob("*"):
            if file.is_file() and file not in self.written:
                file.unlink()

    def place_of(self, name):
        """The page or picture of a file of the repository; made if nothing shows that file yet."""
        if name in self.pages:
            return self.pages[name]
        source = REPOSITORY / name
        if not source.exists():
            fail(f"a link leads to '{name}', which is not there")
        if source.suffix in (".png", ".svg"):
            place = name.removeprefix("docs/")
            self.write(place, source.read_bytes())
        else:
            place = self.source_page(name)
        self.pages[name] = place
        return place

    def source_page(self, name):
        """A page with the text of a file, or of the files of a folder."""
        source = REPOSITORY / name
        place = f"sources/{name}" if source.suffix == ".md" else f"sources/{name}.md"
        self.pages[name] = place
        if source.suffix == ".md":
            self.write(place, "---\norphan: true\n---\n" + self.linked(source.read_text(), name, place))
            return place
        files = [source] if source.is_file() else sorted(file for file in source.iterdir() if file.is_file())
        text = [f"---\norphan: true\n---\n# {name}\n"]
        for file in files:
            if file != source:
                text.append(f"## {file.name}\n")
            text.append(as_markdown(file))
        self.write(place, "\n".join(text))
        return place

    def linked(self, text, name, place):
        """The text of a page, with its links leading to pages of the site."""

        def replace(match):
            target, hash_mark, anchor = match[2].partition("#")
            if not target or re.match(r"[a-z]+:", target):
                return match[0]
            where = os.path.normpath(PurePosixPath(name).parent / target)
            return f"{match[1]}{relative(self.place_of(where), place)}{hash_mark}{anchor})"

        parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
        return "".join(
            part if i % 2 else re.sub(r"(\]\()([^) ]*)\)", replace, part) for i, part in enumerate(parts)
        )


def relative(place, page):
    return os.path.relpath(place, PurePosixPath(page).parent)


def code_block(code, language):
    return f"````{language}\n{code.rstrip()}\n````\n"


def as_markdown(file):
    """The text of a file as a block of code; of a notebook its cells."""
    if file.suffix != ".ipynb":
        return code_block(file.read_text(), LANGUAGES.get(file.suffix, "text"))
    text = []
    for cell in json.loads(file.read_text())["cells"]:
        source = "".join(cell["source"])
        is_code = cell["cell_type"] == "code"
        text.append(code_block(source, "python") if is_code else re.sub("^#", "###", source, flags=re.M) + "\n")
    return "\n".join(text)


def without_licence(code):
    return re.sub(r"\A((//|#).*(SPDX|Copyright).*\n)+\n?", "", code)


def run_example(program, folder):
    """What an example prints, and the pictures that it writes."""
    done = subprocess.run([program], cwd=folder, text=True, capture_output=True, timeout=300)
    if done.returncode:
        fail(f"{program} ended with {done.returncode}: {done.stderr.strip()}")
    return done.stdout.rstrip(), sorted(Path(folder).glob("*.svg"))


def example(site, source, build):
    """Question, code, output and picture of an example."""
    code = without_licence(source.read_text())
    asked = re.match(r"(?://|#) ([^\n]*[^\n.])[.]?\n", code)
    title = asked[1] if asked else "What is the least code for a first plan?"
    text = [f"## {title}\n", f"`{source.relative_to(REPOSITORY)}`\n", code_block(code, LANGUAGES[source.suffix])]
    program = build / "tests" / f"example_{source.stem}" if build else None
    pictures = []
    if program and program.exists():
        with tempfile.TemporaryDirectory() as folder:
            printed, pictures = run_example(program, folder)
            if printed:
                text.append(f"It prints:\n\n{code_block(printed, 'text')}")
            for picture in pictures:
                site.write(f"images/examples/{picture.name}", picture.read_bytes())
                text.append(f"![What it draws](images/examples/{picture.name})\n")
    if not pictures and source.stem in PICTURES:
        picture, caption = PICTURES[source.stem]
        text.append(f"![{caption}]({site.place_of(picture)})\n\n*{caption}.*\n")
    return "\n".join(text)


def write_examples(site, build):
    folder = REPOSITORY / "examples"
    sources = [*sorted(folder.glob("*.cpp")), *sorted(folder.glob("python/*.py"))]
    head = (
        "# Examples\n\nEach is a whole program that the tests compile and run: as it stands here, and against an installed"
        " library.\n"
    )
    site.write("examples.md", "\n".join([head, *(example(site, source, build) for source in sources)]))


def write_python(site):
    """The reference of the Python module, if it can be imported."""
    if subprocess.run([sys.executable, "-c", "import vandplan"], capture_output=True).returncode == 0:
        site.pages["bindings/python"] = "python-reference.md"
        site.write("python-reference.md", (REPOSITORY / "docs/site/python.md").read_text())
    else:
        print("   without the Python reference: the module 'vandplan' cannot be imported")


def check_quotes(text):
    """Figures of the front page stand in the page that they are from."""
    for page, quote in re.findall(r'<!-- quotes (\S+): "(.*?)" -->', text):
        if quote not in (REPOSITORY / page).read_text():
            fail(f"docs/site/index.md quotes {page}, which does not say '{quote}'")


def for_site(text):
    """The front page without what is about Python, where there is no Python module."""
    if (REPOSITORY / "bindings/python").exists():
        return text
    return re.sub(r"^% python\n.*?^% end\n", "", text, flags=re.M | re.S)


def with_tabs(text):
    """The text of a page, with the sections between comments "tabs" and "end of tabs" as tabs."""

    def tabs(match):
        parts = re.split(r"^#### (.*)\n", match[1], flags=re.M)[1:]
        return "\n".join(f"````{{tab}} {label}\n{body.strip()}\n````\n" for label, body in zip(parts[::2], parts[1::2]))

    return re.sub(r"^<!-- tabs -->\n(.*?)^<!-- end of tabs -->\n", tabs, text, flags=re.M | re.S)


def contents(site):
    """The table of contents: the order of docs/README.md."""
    text = (REPOSITORY / "docs/README.md").read_text()
    trees = ["```{toctree}\n:hidden:\n\nAll pages by question <map>\n```\n"]
    for caption, body in re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", text, flags=re.M | re.S):
        entries = re.findall(r"^- \[(.*?)\]\((.*?)\)", body, flags=re.M)
        places = [(label, site.place_of(os.path.normpath(f"docs/{target}"))) for label, target in entries]
        lines = "\n".join(f"{label} <{os.path.splitext(place)[0]}>" for label, place in places if place)
        trees.append(f"```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{lines}\n```\n")
    return "\n" + "\n".join(trees)


def reference_links(site):
    """For a page: what turns the name of a document or header into a link, None if it is none."""

    def for_page(page):
        def link(name):
            if re.fullmatch(r"[a-z_]+\.h", name):
                stem = name.removesuffix(".h")
                known = (REPOSITORY / f"include/vandplan/{name}").exists() and page != f"cpp/{stem}"
                return f":doc:`{name} </cpp/{stem}>`" if known else None
            if name.startswith("include/"):
                return f":doc:`{name} </{os.path.splitext(site.source_page(name))[0]}>`"
            if name.startswith("docs/") and not (REPOSITORY / name).exists():
                site.faults.append(f"{page}: a docstring names '{name}', which is not there")
                return None
            if name.startswith("docs/"):
                place = os.path.splitext(site.place_of(name))[0]
                return f":doc:`{name} </{place}>`"
            return None

        return link

    return for_page


def main():
    folder = Path(sys.argv[1]).resolve()
    build = Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
    site = Site(folder)
    write_python(site)
    for name, place in list(site.pages.items()):
        if name.endswith(".md"):
            text = (REPOSITORY / name).read_text()
            if place == "index.md":
                check_quotes(text)
                text = for_site(text) + contents(site)
            site.write(place, site.linked(with_tabs(text), name, place))
    write_examples(site, build)
    work = folder.parent / "doxygen"
    shutil.rmtree(work, ignore_errors=True)
    reference.write_reference(REPOSITORY, work, site.write, reference_links(site))
    for name, place in (("conf.py", "conf.py"), ("style.css", "_static/style.css"), ("icon.svg", "_static/icon.svg")):
        site.write(place, (REPOSITORY / "docs/site" / name).read_bytes())
    site.remove_others()
    if site.faults:
        fail("\n".join(site.faults))


if __name__ == "__main__":
    main()
