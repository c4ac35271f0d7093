"""A page in German says nothing in English: each message of the program has its German beside it."""

import re
import subprocess

import pytest
from conftest import PROGRAM, ROOT
from test_along import along
from test_noise import CASE

# Small words without which English gets nowhere, and which German does not have. Names of standards and sources keep theirs.
ENGLISH = re.compile(
    r"\b(the|of|and|is|are|at|from|with|by|on|not|over|under|after|which|that|must|no|rails?|wheels?|track|speed|force|level|growth|"
    r"limit|left|right|now|length|wavelength|choose|give|stiff|soft|pads?|sleepers?|ballast|half|driven|typical|chosen)\b"
)
# So do keys and names of a case file.
KEPT = re.compile(r"\b[a-z_]+(?:\.[a-z_]+)+|\b[a-z]+ = |\b[a-z]+(?:-[a-z]+)+|Grassie, Saxon & Smith|Shock and Vibration|Figure \d|\(?\w+ \(?20\d\d\)?.*?;|`[^`]*`|\"[^\"]*\"|„[^“]*“|riffel [a-z-]+|--[a-z-]+")


def english(text):
    return [line for line in text.split("\n") if ENGLISH.search(KEPT.sub("", line))]


def panels(page, view):
    """What stands in a view; options of menus are names of keys."""
    return page.page.locator(f"#view-{view}").evaluate(
        r"""(view) => {
          const copy = view.cloneNode(true);
          for (const one of copy.querySelectorAll('[hidden], select, script, svg.main-svg .legendtext')) one.remove();
          for (const one of copy.querySelectorAll('li, p, td, th, h2, h3, tr, label, text, button, span, div, figcaption')) one.append('\n');
          return copy.textContent;
        }"""
    )


def test_a_measured_rail_is_judged_in_german(open_page, tmp_path):
    page = open_page(locale="de-DE")
    page.open_case(CASE.read_text())
    page.page.click("#tab-measure")
    page.page.click("#sample")
    along(page)
    page.until(lambda: page.page.locator("#noise-parts td").count() > 0)
    told = panels(page, "measure")
    assert "über der Grenze, 1 von 22 Bändern" in told and "führt mit einem Anteil von 0," in told
    assert "Höhen fehlen" in told and "Schiene rechts führt: jetzt über der Grenze" in told
    assert english(told) == []
    assert '"das Rad des Falls"' in told and "the wheel of the case" not in told
    reasons = page.page.locator("#view-measure .card dd").all_inner_texts()
    assert any("gemessen 40,0 mm" in reason for reason in reasons)
    assert english("\n".join(reasons)) == []
    with page.page.expect_download() as download:
        page.page.click("#report")
    file = tmp_path / "report.html"
    download.value.save_as(file)
    report = file.read_text()
    assert '<html lang="de">' in report and "In Kürze" in report and "Was zu schleifen ist" in report
    # What reads the file and where its values come from stays: titles, names and sources.
    words = re.sub(r"<style>.*?</style>|<h2>\d+ Eingaben.*?</section>", "", report, flags=re.S)
    found = english(re.sub(r"<[^>]*>", "\n", words))
    assert [line for line in found if "Values of EN ISO 3095" not in line and "S. L. Grassie" not in line] == [], "a sentence of the report"
    # The same sentences from the program.
    made = subprocess.run([PROGRAM, "roughness", "--synthesise"], capture_output=True, check=True, text=True).stdout
    (tmp_path / "sample.csv").write_text(made)
    command = [PROGRAM, "--language", "de", "roughness", "sample.csv", "-o", "out"]
    printed = subprocess.run(command, capture_output=True, check=True, text=True, cwd=tmp_path).stdout
    verdict = "EN ISO 3095:2013, Figure 2: über der Grenze, 1 von 22 Bändern, am meisten um 17,7 dB bei 40 mm"
    assert verdict in printed and verdict in told
    page.close()


@pytest.mark.without_curves
def test_values_that_are_refused_are_told_in_german(open_page):
    page = open_page(locale="de-DE")
    fault = page.page.locator(".row .fault:visible")
    for key, text, words in [
        ("contact.friction", "3", "Reibung μ ist 3, muss aber zwischen 0,001 und 1,5 liegen"),
        ("contact.normal_load", "50 kg", '"50 kg" ist in kg, nicht eine Kraft in N'),
        ("contact.normal_load", "35O", "unbekannte Einheit"), ("steel.poisson_ratio", "0,7", "muss aber zwischen"), ("map.wavelength.min", "200", "das Fenster ist leer"),
        ("contact.grid", "1,5", "ganze Zahl"), ("map.speed.points", "5000", "Punkte"), ("contact.tractive_ratio", "1,2", "muss aber zwischen"),
    ]:
        before = page.page.locator(f"#key-{key.replace('.', '-')}").input_value()
        page.set(key, text)
        page.until(lambda: fault.count() > 0)
        assert words in fault.first.inner_text(), fault.first.inner_text()
        assert english(fault.first.inner_text()) == [], key
        page.set(key, before)
        page.until(lambda: fault.count() == 0)
    page.close(complaints=len(page.complaints))


@pytest.mark.without_curves
@pytest.mark.parametrize("name", ["curve", "metro", "freight", "tram", "main-line"])
def test_what_is_said_of_a_case_is_german(open_page, name):
    page = open_page(locale="de-DE")
    page.open_case((ROOT / f"cases/{name}.toml").read_text(), f"{name}.toml")
    page.settle()
    told = [page.text(place) for place in ("#why", "#verdict", "#branches", "#cause", "#remedies-panel", "#notes") if page.page.locator(place).is_visible()]
    assert told and english("\n".join(told)) == []
    page.page.click("#tab-compare")
    page.page.click("#keep")
    page.page.locator("#compare-difference").wait_for()
    page.settle()
    assert english(re.sub("\n.*(title|Titel).*", "", page.text("#compare-difference"))) == []
    page.close()


@pytest.mark.without_curves
def test_labels_and_hints_are_german(open_page):
    page = open_page(locale="de-DE")
    labels = page.page.evaluate(
        """() => [...document.querySelectorAll('#keys [data-name]')].map(({ dataset, textContent }) => [dataset.name.split('.').at(-1).replaceAll('_', ' '), textContent])"""
    )
    assert [label for key, label in labels if label == key] == [], "a key that is called as it is written"
    hints = page.page.evaluate("() => [...document.querySelectorAll('#keys [data-hint]')].map(({ hint: [first], title }) => [first?.english ?? first ?? '', title.split('\\n')[0]])")
    assert len(hints) > 150
    assert [hint for hint, shown in hints if hint == shown and " " in hint] == []
    page.close()


def test_curve_and_motion_are_german(open_page):
    page = open_page(locale="de-DE")
    page.page.click("#tab-curve")
    page.until(lambda: page.page.locator("#wheels td").count() > 0)
    assert english(panels(page, "curve")) == []
    page.page.fill("#curve-radius", "25")
    page.page.press("#curve-radius", "Tab")
    page.settle()
    page.page.click("#tab-motion")
    page.until(lambda: page.text("#wave-words") != "" and page.text("#wheelset-words") != "")
    assert "die lineare Antwort" in page.text("#wave-words").replace("Die", "die")
    assert english(panels(page, "motion")) == []
    page.close(complaints=len(page.complaints))


# English that stays. Menus list the names of a case file; titles of cases are those of their authors.
SEEN = r"""() => {
  const seen = new Set();
  const note = (text, node) => {
    for (const line of (text ?? '').split('\n')) if (line.trim()) seen.add(line.trim());
  };
  for (const node of document.querySelectorAll('body *')) {
    if (!node.checkVisibility() || node.closest('option, select, script, style, noscript, #map-title, #key-title, #field th')) continue;
    for (const name of ['title', 'aria-label', 'placeholder', 'aria-valuetext']) note(node.getAttribute(name), node);
    for (const child of node.childNodes) if (child.nodeType === Node.TEXT_NODE) note(child.textContent, node);
  }
  for (const option of document.querySelectorAll('option')) note(option.title, option);
  return [...seen];
}"""
# Papers and books by their titles.
EXCEPTIONS = re.compile(r"Shock and Vibration")


def told_in_english(page):
    seen = page.page.evaluate(SEEN)
    assert len(seen) > 50
    return [line for line in english("\n".join(seen)) if not EXCEPTIONS.search(line)]


def show(page, view):
    """A view with all that it has to say."""
    page.page.click("[popovertarget=take-away]" if view == "explore" else f"#tab-{view}")
    if view == "compare":
        page.page.click("#keep")
        page.page.locator("#compare-difference").wait_for()
        page.settle()
    elif view == "motion":
        # Of the passage, which takes a quarter of a minute here, another test reads the words.
        page.page.locator("#wheelset-modes label").first.wait_for()
    elif view == "curve":
        page.page.locator("#wheels td").first.wait_for()
    elif view == "measure":
        page.page.click("#sample")
        page.page.locator("#noise-parts td").first.wait_for()
    elif view == "paper":
        for number in range(2, 9):
            figure = page.page.locator(f"#figure-{number}")
            figure.scroll_into_view_if_needed()
            page.until(lambda: figure.locator("figure").count() > 0 and not figure.locator(".waiting").is_visible())


@pytest.mark.without_remedies
def test_no_view_says_anything_in_english(open_page):
    """One page, of which each view is opened in turn, with a map of few points: words are the same."""
    page = open_page(locale="de-DE", viewport={"width": 1440, "height": 2400})
    page.page.locator("details").evaluate_all("(all) => all.forEach((one) => (one.open = true))")
    page.open_case(CASE.read_text().replace("points = 241", "points = 61").replace("points = 161", "points = 31"))
    page.set("wheelset.preset", "metro-motor")
    page.settle()
    # Motion is the last: its passage would be computed beside those that follow.
    for view in ["explore", "compare", "curve", "measure", "calibrate", "paper", "motion"]:
        show(page, view)
        assert told_in_english(page) == [], view
    page.close(complaints=len(page.complaints))


@pytest.mark.without_curves
def test_presets_tell_what_they_are_in_german(open_page):
    page = open_page(locale="de-DE")
    for preset in page.page.evaluate("() => window.riffel.state.vocabulary.presets"):
        field = page.page.locator(f"#key-{preset['key'].replace('.', '-')}")
        field.evaluate("(field, name) => { const bubble = document.getElementById(`${field.id}-sources`); bubble.hidePopover(); field.value = name; bubble.showPopover(); }", preset["name"])
        bubble = page.page.locator(f"#key-{preset['key'].replace('.', '-')}-sources")
        assert bubble.locator("strong").get_attribute("lang") == "de", preset["title"]
        assert english(bubble.locator("strong").text_content()) == []
        # What others have published stays as they are cited; what is of our own choice is said in German.
        badges = [value["badge"] for value in preset["values"]]
        rows = bubble.locator("p").evaluate_all("(all) => all.map((row) => [row.firstChild.textContent, row.lastChild.lang, row.lastChild.textContent])")
        assert len(rows) == len(badges) > 0
        for badge, (value, language, source) in zip(badges, rows):
            assert not re.search(r"\d\.\d", value), value
            assert badge != "assumed" or (language == "de" and english(source) == []), source
    page.close()


@pytest.mark.without_curves
def test_a_case_that_has_no_passage_in_time_says_so_in_german(open_page):
    page = open_page(locale="de-DE")
    page.set("wheel.rotation", "constant-tangential-force")
    page.settle()
    page.page.click("#tab-motion")
    page.until(lambda: "hält kein Schlupf die Kraft" in page.text("#wave-words"))
    assert english(page.text("#wave-words")) == []
    page.close(complaints=len(page.complaints))
