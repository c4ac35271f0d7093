"""The first visit: three choices on a supported track, keys that are folded, titles in menus, hints, help and version."""

import subprocess
import tomllib

import pytest
from conftest import PROGRAM, ROOT

pytestmark = pytest.mark.without_remedies


def keys(page):
    return page.page.evaluate("() => window.riffel.state.keys")


def case(name):
    return tomllib.loads((ROOT / "cases" / f"{name}.toml").read_text())


@pytest.mark.without_curves
def test_a_first_visit_chooses_line_vehicle_and_track(open_page):
    page = open_page(visited=None, viewport={"width": 360, "height": 780}, locale="de-DE")
    assert page.page.locator("#start").is_visible()
    assert keys(page) == case("main-line")
    page.fits()
    # Titles, not names, in the language of the page; those of a line are chosen with it.
    chosen = lambda: [page.page.locator(f"#start-{what}").evaluate("(menu) => menu.selectedOptions[0].textContent") for what in ("line", "vehicle", "track")]
    assert chosen() == ["Hauptstrecke", "Angetriebenes Reisezugfahrzeug von Huo & Dai (2019) (50 t)", "60E1 · " + chosen()[2][7:]]
    for line in ("metro", "tram", "freight"):
        page.page.select_option("#start-line", line)
        page.settle()
        assert keys(page) == case(line)
        # Its title is in the language of the page.
        assert page.text("#map-title").startswith({"metro": "U-Bahn: ", "tram": "Straßenbahn: ", "freight": "Güterstrecke: "}[line])
    # Another vehicle brings its own wheel and load, another track its own model.
    page.page.select_option("#start-line", "tram")
    page.page.select_option("#start-vehicle", "metro-trailer-car")
    page.page.select_option("#start-track", "0")
    page.settle()
    made = keys(page)
    assert made["vehicle"] == "metro-trailer-car" and "wheel" not in made and "normal_load" not in made["contact"]
    assert made["rail"]["section"] == "60E1" and made["track"] == {"model": "two-layer-periodic", "preset": "ballasted-stiff-pads", "position": "0 m"}
    assert page.page.evaluate("() => window.riffel.state.current && Boolean(window.riffel.state.head.highest)")
    page.page.click("#undo")
    page.settle()
    assert keys(page) != made
    page.page.click("#redo")
    page.settle()
    # It goes away, and does not come back with a reload.
    page.page.click("#start-go")
    assert not page.page.locator("#start").is_visible()
    page.page.reload()
    page.settle()
    assert not page.page.locator("#start").is_visible() and keys(page) == made
    page.close()


@pytest.mark.without_curves
def test_every_track_of_the_first_visit_is_one_that_the_program_takes(open_page):
    page = open_page(visited=None)
    for k in range(page.page.locator("#start-track option").count()):
        page.page.select_option("#start-track", str(k))
        page.settle()
        assert page.page.evaluate("() => window.riffel.state.current") and not page.page.locator("#trouble .said").is_visible(), keys(page)
    page.close()


@pytest.mark.without_curves
def test_three_hints_help_and_version(open_page):
    page = open_page(visited=None)
    page.page.click("#start-go")
    told = []
    for _ in range(3):
        told.append(page.text("#tour-words"))
        assert page.page.locator(".hinted").count() == 1
        page.page.keyboard.press("Enter")
    assert "slider" in told[0] and "map" in told[1] and "measured" in told[2]
    assert not page.page.locator("#tour").is_visible() and page.page.locator(".hinted").count() == 0
    page.page.click("#help-button")
    version = subprocess.run([PROGRAM, "--version"], capture_output=True, check=True, text=True).stdout.split()[1]
    assert page.text("#version") == f"Riffel {version}"
    page.page.click("#help-tour")
    page.page.keyboard.press("Escape")
    assert not page.page.locator("#tour").is_visible()
    page.page.click("#help-button")
    page.page.click("#help-start")
    assert page.page.locator("#start").is_visible()
    page.close()


@pytest.mark.without_curves
def test_keys_that_a_case_does_not_use_are_folded(page):
    visible = lambda key: page.page.locator(f"#key-{key.replace('.', '-')}").is_visible()
    page.page.locator("#keys details").evaluate_all("(all) => all.forEach((one) => (one.open = true))")
    # The rail of the nominal case has no supports. All keys are shown to who asked for them before.
    assert visible("track.pad.stiffness") and visible("curve.radius")
    page.page.click("#all-keys")
    assert not visible("track.pad.stiffness") and visible("track.model") and not visible("curve.radius")
    page.set("track.model", "two-layer-periodic")
    page.settle()
    assert visible("track.pad.stiffness") and visible("track.sleeper.mass")
    page.set("track.model", "one-layer")
    page.settle()
    assert visible("track.pad.stiffness") and not visible("track.sleeper.mass")


@pytest.mark.without_curves
def test_menus_have_titles_and_names(page):
    option = lambda key, name: page.page.locator(f"#key-{key.replace('.', '-')} option[value='{name}']").text_content()
    assert option("rail.section", "60E1") == "60E1 flat-bottom rail of EN 13674-1 (UIC 60) · 60E1"
    assert option("track.preset", "slab-direct").endswith(" · slab-direct")
    assert option("track.model", "free-beam") not in ("free-beam", "")
    page.page.select_option("#language", "de")
    assert option("track.preset", "slab-direct") == "Feste Fahrbahn mit direkter Befestigung auf starrer Platte (eine Schicht) · slab-direct"
