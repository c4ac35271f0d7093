"""The case on the left: what is the reader's own and the way back, a search, ticks, and the curve of before behind a slider."""

import pytest

OWN = "() => [...document.querySelectorAll('#changed .own')].map((row) => [...row.children].map((cell) => cell.textContent.trim()))"
TICK = "(id) => { const input = document.getElementById(id); return [...input.list.options].map((option) => Number(option.value)); }"
PRESET = "() => ({ ...window.riffel.state.keys.track })"


def own(page):
    page.settle()
    page.pause()
    page.settle()
    return {row[0]: row[1:] for row in page.page.evaluate(OWN)}


@pytest.mark.without_curves
@pytest.mark.parametrize("locale", ["en-GB", "de-DE"])
def test_what_differs_stands_on_top_with_a_way_back(open_page, locale):
    page = open_page(locale=locale)
    page.set("track.model", "two-layer")
    page.settle()
    before = own(page)
    page.set("track.pad.stiffness", "80")
    page.set("contact.friction", "0.5" if locale == "en-GB" else "0,5")
    changed = own(page)
    pads = "Rail pad, stiffness k" if locale == "en-GB" else "Zwischenlage, Steifigkeit k"
    friction = "friction μ" if locale == "en-GB" else "Reibung μ"
    assert set(changed) - set(before) == {pads, friction}
    # The preset of the track has 280 MN/m, the case had a friction of 0.4.
    assert changed[pads] == ["80 MN/m", "↶ 280 MN/m"]
    assert [text.replace(",", ".") for text in changed[friction]] == ["0.5", "↶ 0.4"]
    # The slider has its tick where the preset is, below where it stands now.
    [tick] = page.page.evaluate(TICK, "slide-key-track-pad-stiffness")
    assert tick > float(page.page.input_value("#slide-key-track-pad-stiffness"))
    page.page.locator("#changed .own", has_text=pads).locator("button").click()
    assert pads not in own(page)
    assert "pad" not in page.page.evaluate(PRESET)
    page.page.locator("#changed .own", has_text=friction).locator("button").click()
    assert set(own(page)) == set(before)
    assert page.page.evaluate("() => window.riffel.state.keys.contact.friction") == 0.4
    page.close()


@pytest.mark.without_curves
def test_a_search_finds_a_key_and_the_rest_is_folded(page):
    assert page.page.locator("#keys details[open]:not(#changed)").count() == 0
    page.page.fill("#search-keys", "ballast")
    visible = page.page.locator("#keys .row:not(.own):visible")
    assert visible.count() > 0
    assert all("ballast" in text.lower() for text in visible.evaluate_all("(rows) => rows.map((row) => `${row.querySelector('input, select').id} ${row.querySelector('label').title}`)"))
    page.page.fill("#search-keys", "no such key")
    assert page.text("#keys .fine") == "No key has this name." and visible.count() == 0
    page.page.fill("#search-keys", "")
    assert page.page.locator("#keys details[open]:not(#changed)").count() == 0
    assert page.page.locator("#keys .group:not(#changed) summary:visible").count() > 8


def test_the_curve_of_before_stays_behind_a_slider_that_is_dragged(page):
    ghosts = "(id) => document.getElementById(id).data.filter(({ name }) => name === 'ghost').map(({ y }) => Math.max(...y))"
    highest = "() => Math.max(...window.riffel.state.at.growth.growth_rate_per_passage)"
    before = page.page.evaluate(highest)
    slider = page.page.locator("#slide-key-contact-friction")
    slider.evaluate("(input) => { input.value = 0.2; input.dispatchEvent(new Event('input', { bubbles: true })); }")
    page.settle()
    now = page.page.evaluate(highest)
    [ghost] = page.page.evaluate(ghosts, "growth")
    # Both in one power of ten.
    assert ghost / max(page.page.evaluate("() => document.getElementById('growth').data.at(-2).y")) == pytest.approx(before / now)
    assert len(page.page.evaluate(ghosts, "receptance")) == 2 and len(page.page.evaluate(ghosts, "force")) == 1
    slider.dispatch_event("change")
    page.settle()
    for place in ["growth", "receptance", "force"]:
        assert page.page.evaluate(ghosts, place) == []
