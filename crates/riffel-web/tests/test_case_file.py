"""Case files and links: read, refused, and opened again."""

import pytest
from conftest import ROOT
from test_page import NOMINAL


@pytest.mark.without_curves
def test_a_case_file_that_is_read_slowly_is_awaited(open_page):
    page = open_page()
    page.page.evaluate("() => { const text = File.prototype.text; File.prototype.text = async function () { await new Promise((done) => setTimeout(done, 1000)); return text.call(this); }; }")
    page.open_case(NOMINAL.replace("friction = 0.4", "friction = 0.35"))
    assert page.page.locator("#key-contact-friction").input_value() == "0.35"
    page.close()


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (("friction = 0.4", "frction = 0.4"), "contact.frction is not a key Riffel knows"),
        (('"50 kN"', '"50 kg"'), 'normal load P₀: "50 kg" is in kg, not a force in N; write it as in "50 kN"'),
        (("tractive_ratio = 0.1", "tractive_ratio = 1.2"), "but must be between 1e-6 and 0.999999"),
    ],
)
@pytest.mark.without_curves
def test_a_case_file_with_an_error_says_so_and_what_was_open_stays(open_page, change, sentence):
    page = open_page()
    page.set("contact.friction", "0.3")
    assert change[0] in NOMINAL
    page.open_case(NOMINAL.replace(*change), "bad.toml")
    page.until(page.page.locator("#trouble").is_visible)
    assert sentence in page.text("#trouble").replace("`", "")
    assert "bad.toml, line " in page.text("#trouble")
    page.settle()
    assert page.page.locator("#key-contact-friction").input_value() == "0.3"
    # No field of the case that is open is at fault.
    assert page.page.locator("[aria-invalid]").count() == 0
    page.close(complaints=1)


@pytest.mark.without_curves
def test_an_error_that_is_typed_goes_when_it_is_mended(open_page):
    page = open_page()
    page.set("contact.normal_load", "-50")
    fault = page.page.locator("#key-contact-normal_load-fault")
    page.until(fault.is_visible)
    assert "must be between 0.001 kN and 2000 kN" in fault.inner_text()
    page.set("contact.normal_load", "60")
    page.until(lambda: not fault.is_visible())
    page.close(complaints=1)


@pytest.mark.without_curves
def test_a_case_file_fills_the_form(page):
    page.open_case((ROOT / "cases/discrete-supports.toml").read_text())
    page.until(lambda: page.page.locator("#key-track-model").input_value() == "two-layer-periodic")
    page.settle()
    assert page.page.locator("#key-title").input_value() != "BR main line, tangent track"


@pytest.mark.without_curves
def test_a_link_opens_what_was_seen(page, open_page):
    page.set("contact.friction", "0.27")
    page.set("track.model", "two-layer")
    page.page.click("#tab-compare")
    page.page.click("#keep")
    page.page.locator("#compare-difference").wait_for()
    page.set("contact.friction", "0.31")
    page.settle()
    address = page.page.url
    other = open_page(address.split("/", 3)[3])
    assert other.page.locator("#key-contact-friction").input_value() == "0.31"
    assert other.page.locator("#key-track-model").input_value() == "two-layer"
    assert other.page.locator("#view-compare").is_visible()
    # The variant that was kept comes with it.
    row = other.page.locator("#view-compare tr:has-text('contact.friction')")
    row.wait_for()
    assert row.inner_text().split()[-2:] == ["0.27", "0.31"]
    # The headline lies at the edge of its bands, beyond the map: the case that is opened gets a map that just holds it, on which the cursor stands.
    at = "() => window.riffel.state.headline"
    headline = other.page.evaluate(at)
    assert headline == page.page.evaluate(at) and headline["isEdge"] and headline["wavelength"] > page.page.evaluate("() => window.riffel.state.map.wavelength.max")
    assert other.page.evaluate("() => window.riffel.state.point") == {"wavelength": headline["wavelength"], "speed": headline["speed"], "pinned": False}
    other.close()


@pytest.mark.without_curves
@pytest.mark.parametrize("fragment", ["#", "#nonsense", "#e30", "#" + "A" * 50_000])
def test_a_broken_link_opens_the_nominal_case(open_page, fragment):
    page = open_page(fragment)
    page.settle()
    page.close(complaints=len(page.complaints))
    assert all("422" in complaint for complaint in page.complaints)
