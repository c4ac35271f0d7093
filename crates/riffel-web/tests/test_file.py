"""The page as one file: `riffel page`, opened from the disk, with the network shut.

RIFFEL_WASM is the module of the answers, as `cargo xtask page` builds it; without it these tests are left out.
"""

import base64
import csv
import gzip
import io
import json
import os
import pathlib
import re
import subprocess

import pytest

from conftest import PROGRAM, ROOT, Page

MODULE = pathlib.Path(os.environ.get("RIFFEL_WASM", ROOT / "target/page-module/riffel.wasm.gz"))
pytestmark = pytest.mark.skipif(not MODULE.is_file(), reason="there is no WebAssembly module")

LARGEST = 6_000_000


def write(folder, name, *arguments):
    path = folder / name
    command = [PROGRAM, "page", *arguments, "-o", str(path), "--module", str(MODULE)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return path


@pytest.fixture(scope="session")
def path(tmp_path_factory):
    """The file that all of these tests open."""
    case = ROOT / "cases/metro.toml"
    return write(tmp_path_factory.mktemp("file"), "riffel.html", str(case), "--set", "contact.friction=0.35")


class File(Page):
    """The file in a browser without network."""

    def __init__(self, browser, path, **context):
        super().__init__(browser, path.as_uri(), offline=True, **context)

    def check(self, asked, own):
        if not asked.startswith(("data:", "blob:")) and asked.split("#")[0] != self.address:
            self.foreign.append(asked)

    def open(self, url):
        self.address = url
        super().open(url)


@pytest.fixture(scope="module")
def file(browser, path):
    """One page for the tests in their order, for opening it takes longer than most of them."""
    file = File(browser, path)
    yield file
    file.close()


def test_a_file_of_limited_size_shows_the_case_inside(path, file):
    assert path.stat().st_size <= LARGEST
    # Its own policy lets it reach no network, from whatever place it is opened.
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', path.read_text())[1]
    assert policy.startswith("default-src 'none'") and "http" not in policy and "connect-src" not in policy
    keys = file.page.evaluate("() => window.riffel.state.keys")
    assert keys["title"].startswith("Metro") and keys["contact"]["friction"] == 0.35
    file.keep("file")


def test_what_is_not_inside_is_named_and_not_offered(file):
    assert file.page.locator("[role=tab]").all_inner_texts() == ["Explore", "Compare", "Motion", "Paper"]
    assert "riffel serve" in file.text("#elsewhere")
    for kind in ("png", "svg", "html", "report"):
        assert file.page.locator(f"[data-take={kind}]").count() == 0


def test_the_table_is_that_of_the_program(file, tmp_path):
    """Both to 16 digits: a file computes without fused multiplication and with other exponentials and roots.

    The tolerance is a hundred times what `docs/src/page.md` states for this case.
    """
    file.page.click("[popovertarget=take-away]")
    with file.page.expect_download() as download:
        file.page.click("[data-take=csv]")
    taken = list(csv.DictReader(io.StringIO(pathlib.Path(download.value.path()).read_text())))
    folder = tmp_path / "map"
    case = [str(ROOT / "cases/metro.toml"), "--set", "contact.friction=0.35"]
    subprocess.run([PROGRAM, "map", *case, "-o", str(folder)], check=True, capture_output=True)
    program = list(csv.DictReader((folder / "map.csv").open()))
    assert len(taken) == len(program) > 10_000
    for column in taken[0]:
        pairs = [(float(one[column]), float(other[column])) for one, other in zip(taken, program)]
        largest = max(abs(other) for _, other in pairs)
        worst = max(abs(one - other) for one, other in pairs) / largest
        assert worst <= 1e-12, (column, worst)


def test_a_slider_moves_the_map_and_the_page_stays_fluid(file):
    before = file.map()
    # The second one, of the tractive ratio: friction alone changes growth everywhere alike.
    slider = file.page.locator("#handles input[type=range]").nth(1)
    file.page.evaluate(
        """() => {
          window.longest = 0;
          let last = performance.now();
          const tick = (now) => { window.longest = Math.max(window.longest, now - last); last = now; requestAnimationFrame(tick); };
          requestAnimationFrame(tick);
        }"""
    )
    slider.focus()
    for _ in range(5):
        slider.press("ArrowRight")
    file.settle()
    assert file.map() != before
    # A map of some tenths of a second is computed beside the page, not in it. Drawing curves takes most of this.
    assert file.page.evaluate("() => window.longest") < 1000


def test_variants_are_compared(file):
    file.page.click("#tab-compare")
    file.page.click("#keep")
    file.set("contact.friction", "0.2")
    file.until(lambda: file.page.locator("#compare-difference").is_visible())
    file.until(lambda: file.page.locator("table.comparison tbody tr").count() > 8)
    file.settle()
    file.page.click("#sweep-pads")
    file.until(lambda: file.page.locator("#sweep-table tbody tr").count() == 6)
    file.keep("file-compare")


def test_figures_of_the_paper_are_computed(file):
    file.page.click("#tab-paper")
    figures = file.page.locator("#view-paper article")
    file.until(lambda: figures.first.locator("svg, canvas").count() > 0)
    file.keep("file-paper")


def test_a_wrong_value_is_told_at_its_field(file):
    file.page.click("#tab-explore")
    file.set("contact.friction", "40")
    file.until(lambda: file.page.locator(".row .error, .trouble:not([hidden])").count() > 0)
    file.set("contact.friction", "0.3")
    file.settle()


def test_a_reload_keeps_what_is_shown(file):
    file.set("contact.friction", "0.25")
    file.settle()
    file.page.reload()
    file.settle()
    assert float(file.page.evaluate("() => window.riffel.state.keys.contact.friction")) == 0.25


def test_a_project_is_saved_and_opened(file, tmp_path):
    """One of the page that riffel serve opens, with a record in it, opens here, too, but for the record."""
    file.page.click("#tab-explore")
    file.set("contact.friction", "0.31")
    file.settle()
    file.page.click("[popovertarget=take-away]")
    with file.page.expect_download() as download:
        file.page.click("[data-take=project]")
    text = pathlib.Path(download.value.path()).read_text()
    file.set("contact.friction", "0.2")
    file.settle()
    file.open_case(text, name="all.riffel")
    friction = "() => Number(window.riffel.state.keys.contact.friction)"
    file.until(lambda: file.page.evaluate(friction) == 0.31)
    record = {"name": "new.csv", "gzip_base64": base64.b64encode(gzip.compress(b"x")).decode()}
    file.open_case(json.dumps({**json.loads(text), "record": record}), name="all.riffel")
    file.until(lambda: "riffel serve" in file.text("#notice"))
    assert file.page.evaluate(friction) == 0.31
    file.settle()


def test_german_narrow_and_dark(browser, path):
    file = File(browser, path, locale="de-DE", viewport={"width": 360, "height": 740}, color_scheme="dark")
    assert "Datei" in file.text("#elsewhere")
    file.fits()
    file.keep("file-narrow", whole=True)
    file.close()


def test_files_are_kept_and_pages_replaced(path, tmp_path):
    own = tmp_path / "notes.html"
    own.write_text("notes")
    command = [PROGRAM, "page", "-o", str(own), "--module", str(MODULE)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2 and own.read_text() == "notes" and "--force" in done.stderr
    page = write(tmp_path, "page.html")
    write(tmp_path, "page.html", "--set", "contact.friction=0.2")
    inside = re.search(r'id="case-inside">(.*?)</script>', page.read_text())[1]
    assert json.loads(inside)["contact"]["friction"] == 0.2


def test_what_is_no_module_is_refused(tmp_path):
    other = tmp_path / "module.gz"
    other.write_bytes(b"module")
    command = [PROGRAM, "page", "-o", str(tmp_path / "page.html"), "--module", str(other)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2 and "no compressed WebAssembly module" in done.stderr
    assert not (tmp_path / "page.html").exists()
