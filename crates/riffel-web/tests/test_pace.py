"""How fast the page follows a hand, and what it does where the program is slow."""

import statistics

import pytest
from test_page import drag


def latencies(page):
    return page.page.evaluate(
        """async () => {
          const slider = document.getElementById('slide-key-contact-friction');
          const shown = () => performance.getEntriesByName('riffel-map-shown').length;
          const times = [];
          for (let k = 0; k < 100; k++) {
            slider.value = 0.2 + 0.01 * (k % 25) + 0.005;
            const [begun, before] = [performance.now(), shown()];
            slider.dispatchEvent(new Event('input'));
            while (shown() === before) await new Promise((done) => setTimeout(done, 1));
            // Until it is on the screen.
            await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
            times.push(performance.now() - begun);
            await new Promise((done) => setTimeout(done, 30));
          }
          return times;
        }"""
    )


@pytest.mark.thorough
@pytest.mark.parametrize("size", [(1280, 800), (3840, 2160)], ids=["desktop", "4k"])
def test_the_map_follows_a_slider(open_page, size, capsys):
    page = open_page(viewport=dict(zip(("width", "height"), size)))
    [first, *_] = page.page.evaluate("() => performance.getEntriesByName('riffel-map-shown').map((shown) => shown.startTime)")
    times = latencies(page)
    assert len(times) == 100
    page.close()
    with capsys.disabled():
        parts = statistics.quantiles(times, n=20)
        print(f"\n# {size[0]} × {size[1]}: first map of 241 × 221 after {first:.0f} ms; 100 steps of a slider to the map on the screen, median {statistics.median(times):.0f} ms, 95 % within {parts[18]:.0f} ms")


def test_curves_wait_until_the_map_is_on_the_screen(open_page):
    page = open_page()
    page.page.wait_for_function("() => document.getElementById('growth').data")
    page.settle()
    page.page.evaluate(
        """() => {
          window.drawn = 0;
          document.getElementById('growth').on('plotly_afterplot', () => window.drawn++);
          // A screen that is late.
          const [frame, late] = [window.requestAnimationFrame.bind(window), []];
          window.requestAnimationFrame = (draw) => late.push(draw);
          window.paint = () => {
            window.requestAnimationFrame = frame;
            late.forEach((draw) => frame(draw));
          };
          performance.clearMarks('riffel-map-shown');
          const slider = document.getElementById('slide-key-contact-friction');
          slider.value = 0.405;
          slider.dispatchEvent(new Event('input'));
        }"""
    )
    page.until(lambda: page.page.evaluate("() => performance.getEntriesByName('riffel-map-shown').length"))
    page.pause()
    assert page.page.evaluate("() => window.drawn") == 0
    page.page.evaluate("() => window.paint()")
    page.until(lambda: page.page.evaluate("() => window.drawn") == 1)
    page.close()


@pytest.mark.without_curves
def test_a_fast_hand_is_not_left_behind(open_page):
    page = open_page()
    page.page.evaluate(
        """async () => {
          const slider = document.getElementById('slide-key-contact-tractive_ratio');
          for (let k = 0; k < 300; k++) {
            slider.value = 0.05 + 0.003 * (k % 300);
            slider.dispatchEvent(new Event('input'));
            if (k % 5 === 0) await new Promise((done) => setTimeout(done));
          }
          slider.value = 0.5;
          slider.dispatchEvent(new Event('input'));
        }"""
    )
    page.settle()
    counts = page.page.evaluate("() => window.riffel.traffic")
    assert counts["superseded"] > 100, counts
    # What is shown is the last that was asked.
    shown = page.page.evaluate("() => window.riffel.state.head.complete.contact.tractive_ratio")
    assert shown == 0.5
    page.close(complaints=len(page.complaints))
    # On a loaded machine the program may be busy for a moment: it is asked again, and the browser logs that.
    assert all("503" in complaint for complaint in page.complaints)


@pytest.mark.without_curves
def test_a_busy_program_is_asked_again(open_page):
    page = open_page()
    turned_away = []

    def busy(route):
        if turned_away:
            return route.continue_()
        turned_away.append(route.request.url)
        return route.fulfill(status=503, headers={"Retry-After": "1"}, content_type="application/json", body='{"message": "busy"}')

    page.page.route("**/api/map", busy)
    drag(page, "contact-friction", 0.6)
    page.until(lambda: turned_away)
    page.settle()
    assert len(turned_away) == 1
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.6
    assert not page.page.locator("#trouble").is_visible()
    page.close(complaints=1)
