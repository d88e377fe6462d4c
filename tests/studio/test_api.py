"""What the studio's API answers: to what it is for, to what is not there, and to anything at all."""

import json
from urllib.parse import quote

import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from schemathesis.specs.openapi.checks import positive_data_acceptance

from swerve.cli import main
from swerve.scenario import library_names, load, parse
from tests.studio.servers import JSON, Server

PAPER = load("paper").to_toml()


OPERATIONS = [
    ("GET", "/api/choices"),
    ("GET", "/api/runs"),
    ("GET", "/api/maps"),
    ("GET", "/api/comparisons"),
    ("POST", "/api/scene"),
    ("POST", "/api/jobs"),
    ("GET", "/api/jobs/{number}"),
    ("DELETE", "/api/jobs/{number}"),
    ("GET", "/runs/{name}/report.html"),
    ("GET", "/runs/{name}/thumbnail.svg"),
    ("GET", "/compare"),
    ("GET", "/maps/{name}/map.html"),
    ("GET", "/maps/{name}/replays/{replay}"),
    ("GET", "/comparisons/{name}/{page}"),
    ("GET", "/comparisons/{name}/{run}/report.html"),
]


WITHOUT_INPUT = OPERATIONS[:4]
RIGHT, WRONG = schemathesis.GenerationMode.POSITIVE, schemathesis.GenerationMode.NEGATIVE
CASES = [(*each, mode) for each in OPERATIONS for mode in (RIGHT, WRONG) if mode is RIGHT or each not in WITHOUT_INPUT]
DEEPER = [positive_data_acceptance]  # what a scenario allows is told by its own schema, not by the API's


@pytest.fixture(scope="module")
def schema(server: Server) -> schemathesis.BaseSchema:
    """What the server says of its own API."""
    return schemathesis.openapi.from_url(f"{server.address}/api/openapi.json")


def test_the_api_is_what_is_fuzzed(schema: schemathesis.BaseSchema) -> None:
    """No operation is left out below."""
    found = [(each.ok().method.upper(), each.ok().path) for each in schema.get_all_operations()]
    assert sorted(found) == sorted(OPERATIONS)


@pytest.mark.parametrize(("method", "path", "mode"), CASES)
def test_whatever_is_asked_is_answered_as_told(
    schema: schemathesis.BaseSchema, method: str, path: str, mode: schemathesis.GenerationMode
) -> None:
    """Whatever the API's description allows, and what it does not, is answered by its own words and never fails."""
    operation = schema[path][method]

    @settings(max_examples=12, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
    @given(case=operation.as_strategy(generation_mode=mode))
    def check(case: schemathesis.Case) -> None:
        case.call_and_validate(excluded_checks=DEEPER)

    check()


@pytest.mark.parametrize(
    "path",
    [
        "/runs/../result.json",
        "/runs/%2e%2e/report.html",
        "/runs/..%2f..%2fetc%2fpasswd/report.html",
        "/runs/unified/../../../../etc/passwd",
        "/runs/unified/result.json",
        "/runs/%2fetc/report.html",
        "/runs/unified%00/report.html",
        "/runs/empty/report.html",
        "/runs/notes.txt/thumbnail.svg",
        "/assets/../app.py",
        "/assets/..%2fapp.py",
        "/compare?first=..&second=unified",
        "/compare?first=unified&second=%2fetc",
        "/maps/../map.html",
        "/maps/unified/map.html",
        "/comparisons/../report.html",
        "/comparisons/unified/report.html",
        "/comparisons/%2e%2e/unified/report.html",
        "//etc/passwd",
    ],
)
def test_no_path_leads_out_of_the_folder(server: Server, path: str) -> None:
    """What is no run of the folder by its name is not there."""
    status, _, body = server.ask(path)
    assert (status, list(json.loads(body))) == (404, ["detail"])


@pytest.mark.parametrize(
    ("path", "body", "status", "words"),
    [
        ("/api/jobs", b"", 422, "body"),
        ("/api/jobs", b"{", 422, "body.1: JSON decode error"),
        ("/api/jobs", b"[]", 422, "body: "),
        ("/api/jobs", b"\xff\xfe", 422, "body.0: JSON decode error"),
        ("/api/jobs", b'{"toml": 3}', 422, "body.toml: "),
        ("/api/jobs", b'{"toml": ""}', 422, "scene: empty; a scenario has name, duration"),
        ("/api/jobs", b'{"toml": "name = "}', 422, "scene: not valid TOML"),
        ("/api/jobs", b'{"toml": "\\ud800"}', 422, "body.toml: "),
        ("/api/jobs", b'{"toml": "nam = 1"}', 422, "scene: nam: unknown key; did you mean name?"),
        ("/api/jobs", b'{"toml": "", "evil": 1}', 422, "body.evil: "),
        ("/api/jobs", json.dumps({"toml": "x" * 30_000}).encode(), 422, "body.toml: "),
        ("/api/jobs", b'{"toml": "", "seed": 1e400}', 422, "body.seed: "),
        ("/api/jobs", json.dumps({"toml": PAPER, "controller": "unifid"}).encode(), 422, "did you mean unified?"),
        ("/api/jobs", json.dumps({"toml": PAPER, "plant": "moon"}).encode(), 422, "unknown plant 'moon'"),
        ("/api/scene", b'{"scenario": "paper", "speed": NaN}', 422, "body.speed"),
        ("/api/scene", b'{"scenario": "paper", "speed": true}', 422, "body.speed"),
        ("/api/scene", b'{"scenario": "paper", "friction": -1}', 422, "road.friction: -1.0 is out of range"),
        ("/api/scene", b"[" * 5000, 400, "parsing the body"),
    ],
)
def test_junk_is_told_what_is_wrong(server: Server, path: str, body: bytes, status: int, words: str) -> None:
    """What is no request is refused with a sentence of one line."""
    found, _, answer = server.ask(path, "POST", body, JSON)
    detail = json.loads(answer)["detail"]
    assert found == status
    assert words in detail
    assert detail.isprintable()


def test_everything_with_a_name_can_be_chosen(server: Server, capsys: pytest.CaptureFixture[str]) -> None:
    """What `swerve scenarios` lists is offered, a family's members under it, and begins where its numbers are."""
    assert main(["scenarios", "--json"]) == 0
    known = [each["name"] for each in json.loads(capsys.readouterr().out)]
    choices = server.get("/api/choices")
    starts = {each["name"]: each["start"] for each in choices["scenarios"]}
    assert list(starts) == known
    assert [each for family in choices["families"] for each in family["members"]] == known[len(library_names()) :]
    assert choices["families"][0]["pattern"] == "ccrs-SPEED-ilIMPACT"
    assert starts["ccrs-50-il75"]["speed"] == pytest.approx(50 / 3.6)
    assert starts["ccrs-50-il75"]["offset"] == pytest.approx(0.25 * 1.815)


def test_a_member_of_a_family_is_a_scene(server: Server) -> None:
    """What comes back for it loads as the member does on the command line."""
    status, answer = server.post("/api/scene", {"scenario": "cut-out-90-70"})
    assert status == 200
    assert parse(answer["toml"].encode(), "scene") == load("cut-out-90-70")


def test_a_form_of_another_page_is_no_json(server: Server) -> None:
    """What a form could send without being asked first, as text, is not taken for JSON."""
    body = json.dumps({"scenario": "paper"}).encode()
    assert server.ask("/api/scene", "POST", body, {"Content-Type": "text/plain"})[0] == 422


def test_a_scenario_that_a_plant_cannot_run_is_told_at_once(server: Server) -> None:
    """The queue does not take what would fail when its turn comes."""
    toml = PAPER.replace("patches = []", "patches = [{ x = [0, 5], friction = 0.3 }]")
    status, answer = server.post("/api/jobs", {"toml": toml, "plant": "planar"})
    assert status == 422
    assert "the planar plant has one friction for all wheels" in answer["detail"]


def test_every_run_has_its_report_and_picture(server: Server) -> None:
    """What is listed can be opened, by its name as it is; one that cannot be read says so in its picture's place."""
    for run in server.get("/api/runs"):
        name = quote(run["name"], safe="")
        status, headers, body = server.ask(f"/runs/{name}/report.html")
        assert (status, headers["content-type"]) == (200, "text/html; charset=utf-8")
        assert "default-src 'none'" in headers["content-security-policy"]
        assert body == (server.directory / run["name"] / "report.html").read_bytes()
        status, headers, body = server.ask(f"/runs/{name}/thumbnail.svg")
        assert status == (200 if run["fault"] is None else 422)
        assert headers["content-type"] == ("image/svg+xml" if run["fault"] is None else "application/json")


def test_runs_of_one_scene_are_drawn_together(server: Server) -> None:
    """The comparison of two runs of one scene is one page with both; of different scenes it is both reports."""
    both = server.ask("/compare?first=unified&second=as%20printed")[2].decode()
    assert "2 runs of one scene" in both
    two = server.ask(f"/compare?first=unified&second={quote('<b>&')}")[2].decode()
    assert 'src="/runs/unified/report.html"' in two
    assert 'src="/runs/%3Cb%3E%26/report.html" title="Report of &lt;b&gt;&amp;"' in two
