"""`riffel serve` itself: who may ask, and what it leaves behind."""

import json
import os
import pathlib
import signal
import subprocess
import urllib.request

import pytest
from conftest import PATIENCE, PROGRAM, Served
from test_measure import two_rails


def test_other_machines_are_let_in_with_a_warning_only(tmp_path):
    program = subprocess.Popen(
        [PROGRAM, "serve", "--port", "0", "--address", "0.0.0.0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        text=True, env={**os.environ, "TMPDIR": str(tmp_path)},
    )
    assert program.stdout.readline().startswith("http://127.0.0.1:")
    program.terminate()
    assert "warning: other machines can reach this page" in program.communicate(timeout=PATIENCE)[1]


def test_a_port_that_is_taken_is_told(served):
    port = served.url.rsplit(":", 1)[1].strip("/")
    outcome = subprocess.run([PROGRAM, "serve", "--port", port], capture_output=True, text=True, timeout=PATIENCE)
    assert outcome.returncode == 2
    assert f"cannot listen on 127.0.0.1:{port}" in outcome.stderr and "--port 0" in outcome.stderr


def test_nobody_else_may_ask(served):
    def asked(headers):
        request = urllib.request.Request(served.url + "api/map", b"{}", {"Content-Type": "application/json", **headers})
        with pytest.raises(urllib.error.HTTPError) as answer:
            urllib.request.urlopen(request)
        return answer.value.code

    assert asked({}) == 403
    assert asked({"Origin": "http://evil.example"}) == 403
    assert asked({"Host": "evil.example", "Origin": "http://evil.example"}) == 421


@pytest.mark.parametrize("signal_", [signal.SIGTERM, signal.SIGINT])
def test_the_end_leaves_nothing_behind(tmp_path, signal_):
    served = Served(tmp_path)
    host = served.url[7:-1]
    headers = {"Origin": f"http://{host}", "X-Riffel-Page": "a", "Content-Type": "text/csv"}
    request = urllib.request.Request(served.url + "api/upload", two_rails(3).encode(), headers)
    assert json.load(urllib.request.urlopen(request))["bytes"] > 1000
    assert len(list(tmp_path.iterdir())) == 1
    assert served.end(signal_) == 0
    assert list(tmp_path.iterdir()) == []


def test_after_a_crash_the_next_start_clears_up(tmp_path):
    crashed = Served(tmp_path)
    crashed.end(signal.SIGKILL)
    left = list(tmp_path.iterdir())
    assert len(left) == 1
    following = Served(tmp_path)
    assert not pathlib.Path(left[0]).exists()
    following.end()
    assert list(tmp_path.iterdir()) == []
