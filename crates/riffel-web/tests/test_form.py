"""The case on the left: what is typed, what is refused, what a file and the first visit bring, and the way back."""

import tomllib

import pytest
from conftest import ROOT

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]

NOMINAL = (ROOT / "cases/nominal.toml").read_text()
FRICTION = "() => window.riffel.state.keys.contact.friction"


def complete(page, key):
    """The value of a key as the program has it, in SI."""
    value = page.page.evaluate("() => window.riffel.state.head.complete")
    for part in key.split("."):
        value = value[part]
    return float(str(value).split()[0])


def field(page, key, what=""):
    return page.page.locator(f"#key-{key.replace('.', '-')}{what and f'-{what}'}")


def value(page, key):
    return field(page, key).input_value()


def drop(page, text, name):
    page.page.evaluate(
        """([text, name]) => {
          const files = new DataTransfer();
          files.items.add(new File([text], name));
          document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
        }""",
        [text, name],
    )


def test_a_number_that_can_be_read_two_ways_is_asked_about(page):
    page.set("wheel.mass", "1,000")
    question = field(page, "wheel.mass", "fault")
    page.until(question.is_visible)
    page.settle()
    # Nothing has changed, and what was typed is still there.
    assert complete(page, "wheel.mass") == 350 and value(page, "wheel.mass") == "1,000"
    assert page.page.locator("#trouble [data-field]").count() == 1
    question.get_by_text("1000 kg").click()
    page.settle()
    assert complete(page, "wheel.mass") == 1000
    assert not question.is_visible() and not page.page.locator("#trouble").is_visible()


def test_what_is_typed_is_read_by_the_program_and_echoed(page):
    for key, text, read, echo in [
        ("wheel.mass", "1.000", 1, "= 1 kg; before it was 350 kg. Is that meant?"), ("wheel.mass", "770 lb", 349.266, "349.3 kg"), ("wheel.rolling_radius", "18 in", 0.4572, "457.2 mm"), ("map.speed.max", "125 mph", 55.88, "201.2 km/h"),
        ("wear.coefficient", "2.6·10⁻⁹", 2.6e-9, ""), ("contact.normal_load", "22 kip", 97860.9, "97.86 kN"), ("contact.friction", "30 %", 0.3, "0.3"),
    ]:
        page.set(key, text)
        page.settle()
        assert complete(page, key) == pytest.approx(read, rel=1e-5)
        # What was typed stays, the unit beside it is that of a bare number, and the page says what it has read.
        assert value(page, key) == text
        assert echo in field(page, key, "echo").inner_text()
    # A ratio in per cent does not make per cent of the next.
    page.set("contact.friction", "0.3")
    page.settle()
    assert complete(page, "contact.friction") == pytest.approx(0.3)


# Long: has every refused value told at its field.
def test_what_is_refused_is_said_at_its_field_in_its_unit_and_pales_what_is_shown(page):
    shown = page.page.locator(".row .fault:visible")
    pale = lambda: page.page.locator("#view-explore .stale:visible").count()
    for key, text, words in [
        ("contact.normal_load", "-50", ["normal load P₀ is −50 kN", "0.001 kN and 2000 kN"]), ("map.wavelength.points", "5000", ["points"]), ("contact.contact_angle", "5", ["between −1.5708 rad and 1.5708 rad"]),
        ("map.wavelength.min", "200", ["Wavelengths, to is 80 mm", "200 mm"]), ("wheel.mass", "1e400", []),
    ]:
        before = value(page, key)
        page.set(key, text)
        page.until(lambda: shown.count() > 0 and pale() >= 5)
        said = shown.first.inner_text()
        assert all(word in said for word in words), said
        for inside in ["f64", "`", "contact.", "map.", "riffel ", "--", "invalid type", "nfinity"]:
            assert inside not in said
        assert value(page, key) == text
        # The cursor still moves over the case that is shown, without further errors.
        page.settle()
        page.refused(422)
        page.page.locator("#map canvas").last.focus()
        page.page.keyboard.press("ArrowUp")
        page.settle()
        assert page.complaints == []
        page.set(key, before)
        page.until(lambda: shown.count() == 0 and pale() == 0)
        page.settle()
    # The language of a refusal is that of the page.
    page.set("contact.normal_load", "50 kg")
    page.until(lambda: shown.count() > 0)
    # A refused unit does not become that of the field.
    assert field(page, "contact.normal_load", "unit").text_content() == "kN"
    page.speak("de")
    assert '"50 kg" ist in kg, nicht eine Kraft in N' in shown.first.inner_text() and shown.first.get_attribute("lang") == "de"
    page.refused(422)


def test_every_view_counts_and_leads_to_what_is_not_accepted(page):
    for key, text in [("contact.normal_load", "-50"), ("steel.poisson_ratio", "0.7"), ("rail.mass_per_length", "1 kN")]:
        page.set(key, text)
    names = page.page.locator("#trouble [data-field]")
    page.until(lambda: names.count() == 3)
    for view in ["compare", "measure", "paper"]:
        page.page.click(f"#tab-{view}")
        assert page.page.locator("#trouble span").first.inner_text().startswith("3 "), view
    # From the last view to the field.
    page.page.evaluate("() => document.querySelectorAll('details').forEach((group) => (group.open = false))")
    names.filter(has_text="P₀").click()
    assert page.page.evaluate("() => document.activeElement.id") == "key-contact-normal_load"
    assert page.page.locator("#view-explore").is_visible()
    # What cannot be handed out says so.
    page.page.click("[popovertarget=take-away]")
    page.page.click("[data-take=png]")
    page.until(lambda: page.page.locator("#trouble .said").count() == 1)
    for key, text in [("contact.normal_load", "50"), ("rail.mass_per_length", ""), ("steel.poisson_ratio", "0.3")]:
        page.set(key, text)
    page.until(lambda: not page.page.locator("#trouble").is_visible())
    page.refused(422)


def test_a_case_that_never_had_an_answer_is_not_said_to_be_shown(page):
    page.set("wheel.mass", "350 stones")
    page.until(page.page.locator("#trouble [data-field]").is_visible)
    assert "is the last case without an error" in page.text("#trouble")
    page.settle()
    page.page.reload()
    page.until(page.page.locator("#trouble [data-field]").is_visible)
    assert "nothing can be shown before" in page.text("#trouble")
    page.page.locator("#trouble [data-field]").click()
    assert value(page, "wheel.mass") == "350 stones"
    # A value that is missing is not shown as one that stands in for it.
    page.set("wheel.mass", "")
    page.until(lambda: "is missing" in page.text("#key-wheel-mass-fault"))
    assert field(page, "wheel.mass").get_attribute("placeholder") == ""
    page.set("wheel.mass", "350")
    page.settle()
    assert field(page, "wheel.inertia").get_attribute("placeholder") != "" and not page.page.locator("#trouble").is_visible()
    page.refused(422)


def test_a_wheelset_is_shown_and_edited(page):
    # Growth under the traffic of a flexible wheelset takes seconds, and is none of this.
    page.page.route("**/api/line", lambda route: route.fulfill(status=422, json={"message": "not asked"}))
    text = (ROOT / "cases/curve.toml").read_text().replace('"300 mm" }', '"300 mm", points = 11 }').replace('"15 m/s" }', '"15 m/s", points = 7 }')
    # A file that is read slowly is awaited.
    page.page.evaluate("() => { const text = File.prototype.text; File.prototype.text = async function () { await new Promise((done) => setTimeout(done, 300)); return text.call(this); }; }")
    page.open_case(text, "curve.toml")
    assert [value(page, key) for key in ("wheelset.model", "wheelset.axle.diameter", "contact.creepage.lateral", "contact.creepage", "wheel.mass")] == ["flexible", "160", "1.7 %", "", ""]
    assert value(page, "wheelset.discs").count("polar_inertia") == 4
    # The loop at the cursor is that of the map, with a lateral force and no one angular velocity.
    assert "lateral force" in page.text("#amplitudes") and "angular velocity" not in page.text("#amplitudes")
    before = page.map()
    page.set("wheelset.discs", value(page, "wheelset.discs").replace("350 kg", "500 kg"))
    page.set("wheelset.opposite_rail", "in-phase")
    page.settle()
    assert page.map() != before
    # A list that cannot be is refused at its field.
    page.set("train.wheels", "0 m, 2.5 m, 2.5 m")
    fault = field(page, "train.wheels", "fault")
    page.until(fault.is_visible)
    assert "two wheels must not be at one place" in fault.inner_text()
    page.set("train.wheels", "0 m, 2.5 m")
    page.until(lambda: not fault.is_visible())
    # A number takes the place of the table, and the table that of the number.
    page.set("contact.creepage", "0.1 %")
    page.settle()
    assert value(page, "contact.creepage.lateral") == ""
    page.set("contact.creepage.lateral", "0.3 %")
    page.settle()
    assert value(page, "contact.creepage") == ""
    page.refused(422)


VALUES = "(name) => window.riffel.state.vocabulary.presets.find((preset) => preset.name === name).values.length"


def test_presets_take_the_place_of_values_and_tell_their_sources(page):
    page.set("vehicle", "metro-motor-car")
    page.settle()
    assert value(page, "wheel.mass") == "" != field(page, "wheel.mass").get_attribute("placeholder")
    page.set("wheelset.preset", "metro-trailer")
    page.settle()
    assert field(page, "wheelset.discs").get_attribute("placeholder").count("polar_inertia") > 1
    page.page.set_viewport_size({"width": 390, "height": 420})
    for block in ["start", "end"]:
        field(page, "vehicle").evaluate("(field, block) => field.scrollIntoView({ block })", block)
        page.page.locator(".row:has(#key-vehicle) .info").press("Enter")
        bubble = page.page.locator("#key-vehicle-sources")
        bubble.wait_for()
        assert len(bubble.inner_text()) > 100 and bubble.locator("p").count() == page.page.evaluate(VALUES, "metro-motor-car")
        # Inside the window, wherever its button is.
        box = bubble.bounding_box()
        assert box["x"] >= 0 and box["x"] + box["width"] <= 390 and box["y"] >= 0 and box["y"] + box["height"] <= 420
        page.page.keyboard.press("Escape")


def test_a_case_file_with_an_error_says_so_and_what_was_open_stays(page):
    page.set("contact.friction", "0.3")
    for change, sentence in [(("friction = 0.4", "frction = 0.4"), "contact.frction is not a key Riffel knows"), (('"50 kN"', '"50 kg"'), 'normal load P₀: "50 kg" is in kg, not a force in N; write it as in "50 kN"')]:
        page.open_case(NOMINAL.replace(*change), "bad.toml")
        page.until(lambda: sentence in page.text("#trouble").replace("`", ""))
        assert "bad.toml, line " in page.text("#trouble")
        # No field of the case that is open is at fault.
        assert value(page, "contact.friction") == "0.3" and page.page.locator("[aria-invalid]").count() == 0
    page.refused(422)


def test_files_that_are_dropped_and_starting_over_can_be_undone(page):
    page.set("contact.friction", "0.3")
    page.page.click("[popovertarget=take-away]")
    page.page.click("[data-take=nominal]")
    page.until(lambda: page.page.evaluate(FRICTION) == 0.4)
    page.page.locator("#notice").get_by_text("Undo").click()
    page.until(lambda: page.page.evaluate(FRICTION) == 0.3)
    drop(page, NOMINAL.replace("friction = 0.4", "friction = 0.55"), "other.toml")
    page.until(lambda: page.page.evaluate(FRICTION) == 0.55)
    assert "other.toml" in page.text("#notice")
    page.page.locator("#notice").get_by_text("Undo").click()
    page.until(lambda: page.page.evaluate(FRICTION) == 0.3)
    # What is no case is a record, though none.
    drop(page, "Dear all,", "letter.txt")
    page.until(page.page.locator("#trouble").is_visible)
    assert "letter.txt" in page.text("#trouble") and "riffel-serve" not in page.text("#trouble")
    assert page.page.locator("#view-measure").is_visible()
    page.refused(422)


OWN = "() => [...document.querySelectorAll('#changed .own')].map((row) => [...row.children].map((cell) => cell.textContent.trim()))"
TICK = "(id) => { const input = document.getElementById(id); return [...input.list.options].map((option) => Number(option.value)); }"


def test_what_differs_stands_on_top_with_a_way_back(page):
    def own():
        page.settle()
        return {row[0]: row[1:] for row in page.page.evaluate(OWN)}

    page.set("track.model", "two-layer")
    before = own()
    page.set("track.pad.stiffness", "80")
    page.set("contact.friction", "0.5")
    changed = own()
    pads, friction = "Rail pad, stiffness k", "friction μ"
    assert set(changed) - set(before) == {pads, friction}
    # The preset of the track has 280 MN/m, the case had a friction of 0.4.
    assert changed[pads] == ["80 MN/m", "↶ 280 MN/m"] and changed[friction] == ["0.5", "↶ 0.4"]
    # The slider has its tick where the preset is, below where it stands now.
    [tick] = page.page.evaluate(TICK, "slide-key-track-pad-stiffness")
    assert tick > float(page.page.input_value("#slide-key-track-pad-stiffness"))
    for name in (pads, friction):
        page.page.locator("#changed .own", has_text=name).locator("button").click()
        assert name not in own()
    assert set(own()) == set(before) and page.page.evaluate(FRICTION) == 0.4


def test_keys_are_found_folded_and_named(page):
    page.page.fill("#search-keys", "ballast")
    visible = page.page.locator("#keys .row:not(.own):visible")
    assert visible.count() > 0
    assert all("ballast" in text.lower() for text in visible.evaluate_all("(rows) => rows.map((row) => `${row.querySelector('input, select').id} ${row.querySelector('label').title}`)"))
    page.page.fill("#search-keys", "no such key")
    assert page.text("#keys .fine") == "No key has this name." and visible.count() == 0
    page.page.fill("#search-keys", "")
    assert page.page.locator("#keys details[open]:not(#changed)").count() == 0
    # All keys are shown to who asked for them before; the rail of the nominal case has no supports.
    page.page.locator("#keys details").evaluate_all("(all) => all.forEach((one) => (one.open = true))")
    shown = lambda key: field(page, key).is_visible()
    assert shown("track.pad.stiffness") and shown("curve.radius")
    page.page.click("#all-keys")
    assert not shown("track.pad.stiffness") and shown("track.model") and not shown("curve.radius")
    page.set("track.model", "one-layer")
    page.settle()
    assert shown("track.pad.stiffness") and not shown("track.sleeper.mass")
    # Menus have titles before names.
    option = lambda key, name: page.page.locator(f"#key-{key.replace('.', '-')} option[value='{name}']").text_content()
    assert option("rail.section", "60E1") == "60E1 flat-bottom rail of EN 13674-1 (UIC 60) · 60E1"
    page.speak("de")
    assert option("track.preset", "slab-direct") == "Feste Fahrbahn mit direkter Befestigung auf starrer Platte (eine Schicht) · slab-direct"


def test_a_finger_reaches_the_hint_of_a_key(open_page):
    page = open_page(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    content = "(field) => getComputedStyle(field.closest('.row').querySelector('label'), '::after').content"
    friction = field(page, "contact.friction")
    friction.evaluate("(field) => (field.closest('details').open = true)")
    assert friction.evaluate(content) == "none"
    page.page.locator("label[for=key-contact-friction]").tap()
    assert "contact.friction" in friction.evaluate(content)


def keys(page):
    return page.page.evaluate("() => window.riffel.state.keys")


# Long: maps every line, vehicle and track that a first visit offers.
def test_a_first_visit_chooses_line_vehicle_and_track(open_page):
    page = open_page(visited=None, viewport={"width": 360, "height": 780}, locale="de-DE")
    case = lambda name: tomllib.loads((ROOT / f"cases/{name}.toml").read_text())
    assert page.page.evaluate("() => document.activeElement.id") == "start-line"
    before = "() => Boolean(document.getElementById('start').compareDocumentPosition(document.getElementById('case')) & Node.DOCUMENT_POSITION_FOLLOWING)"
    assert page.page.evaluate(before) and keys(page) == case("main-line")
    page.fits()
    # Titles, not names, in the language of the page; those of a line are chosen with it.
    chosen = lambda: [page.page.locator(f"#start-{what}").evaluate("(menu) => menu.selectedOptions[0].textContent") for what in ("line", "vehicle", "track")]
    assert chosen() == ["Hauptstrecke", "Angetriebenes Reisezugfahrzeug von Huo & Dai (2019) (50 t)", "60E1 · " + chosen()[2][7:]]
    page.page.select_option("#start-line", "tram")
    page.settle()
    assert keys(page) == case("tram") and page.text("#map-title").startswith("Straßenbahn: ") and "(20–50 km/h, 2400" in page.text("#verdict")
    # Another vehicle brings its own wheel and load, another track its own model.
    page.page.select_option("#start-vehicle", "metro-trailer-car")
    page.page.select_option("#start-track", "0")
    page.settle()
    made = keys(page)
    assert made["vehicle"] == "metro-trailer-car" and "wheel" not in made and "normal_load" not in made["contact"]
    assert made["rail"]["section"] == "60E1" and made["track"] == {"model": "two-layer-periodic", "preset": "ballasted-stiff-pads", "position": "0 m"}
    assert page.page.evaluate("() => window.riffel.state.current && Boolean(window.riffel.state.head.highest)")
    # A choice is a step.
    page.page.click("#undo")
    page.settle()
    assert keys(page)["vehicle"] == made["vehicle"] and keys(page)["rail"] != made["rail"]
    page.page.click("#redo")
    page.settle()
    assert keys(page) == made
    # It is of the map; it goes away, and does not come back with a reload.
    page.page.click("#tab-paper")
    assert page.page.locator("#start").is_hidden()
    page.page.click("#tab-explore")
    page.page.click("#start-go")
    assert not page.page.locator("#start").is_visible()
    page.page.reload()
    page.settle()
    assert not page.page.locator("#start").is_visible() and keys(page) == made


def test_three_hints_help_and_version(page):
    page.page.click("#help-button")
    assert page.text("#version").startswith("Riffel ")
    page.page.click("#help-start")
    page.page.click("#start-go")
    told = []
    for _ in range(3):
        told.append(page.text("#tour-words"))
        assert page.page.locator(".hinted").count() == 1
        page.page.keyboard.press("Enter")
    assert "slider" in told[0] and "map" in told[1] and "measured" in told[2]
    assert not page.page.locator("#tour").is_visible() and page.page.locator(".hinted").count() == 0
    # On a phone the hint leaves the sliders free.
    page.page.set_viewport_size({"width": 390, "height": 844})
    page.page.click("#help-button")
    page.page.click("#help-tour")
    sliders, hint = (page.page.locator(selector).bounding_box() for selector in ("#handles", "#tour"))
    assert hint["y"] >= sliders["y"] + sliders["height"] and hint["y"] + hint["height"] <= 844 and sliders["y"] >= 0
    page.page.keyboard.press("Escape")
    assert not page.page.locator("#tour").is_visible()


def test_a_traffic_shows_what_it_was_read_as_and_asks(page):
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    # The wheels of a bogie are those of a curve.
    assert page.page.locator("#traffic-all-wheels").is_hidden()
    band = "() => { const { view } = document.getElementById('map'); return [view.band.to, view.taken.map(({ words }) => words)]; }"
    assert "usual traffic" in page.page.evaluate(band)[1]

    def type_(name, text):
        page.page.fill(f"#traffic-{name}", text)
        page.page.press(f"#traffic-{name}", "Tab")

    type_("daily", "7,500")
    page.until(page.page.locator("#traffic-daily-fault").is_visible)
    assert "7.5 1/d" in page.text("#traffic-daily-fault") and page.page.locator("#trouble [data-field]").count() == 1
    page.page.locator("#traffic-daily-fault button").first.click()
    page.until(lambda: "7500" in page.text("#traffic-group summary"))
    assert not page.page.locator("#trouble").is_visible()
    type_("to", "120 mph")
    assert page.text("#traffic-to-echo") == "= 193.1 km/h"
    # The speeds lie on the map, and the headline and the cursor go by them.
    page.settle()
    to, words = page.page.evaluate(band)
    assert to == pytest.approx(120 * 0.44704) and "traffic" in words and "usual traffic" not in words
    assert "under the traffic given (80–193 km/h, 7500 axles a day);" in page.text("#verdict") and "usual" not in page.text("#why")
    # Vehicles take the place of its speeds; what makes no traffic says why.
    page.page.click("#add-vehicle")
    page.page.click("#add-vehicle")
    assert not page.page.locator("#traffic-from").is_visible()
    page.page.fill("#vehicle-1-share", "60")
    page.page.press("#vehicle-1-share", "Tab")
    page.until(lambda: "sum to 110 %" in page.text("#vehicles-fault"))
    assert page.page.locator("#trouble [data-field]").count() == 1
    page.page.fill("#vehicle-1-share", "50")
    page.page.press("#vehicle-1-share", "Tab")
    page.until(lambda: not page.page.locator("#trouble").is_visible())
    page.settle()
    address = page.page.url
    page.page.click("#vehicles [role=group]:first-child button")
    page.page.click("#vehicles [role=group] button")
    page.until(page.page.locator("#traffic-from").is_visible)
    page.page.evaluate("(link) => (location.hash = link.split('#')[1])", address)
    page.until(lambda: page.page.locator("#vehicles [role=group]").count() == 2)
