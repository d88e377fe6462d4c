"""Who may ask the studio, and for how much."""

import json

import pytest

from swerve.studio.guard import LARGEST_BODY
from tests.studio.servers import JSON, Server

ORDER = {"toml": "", "controller": "unified", "plant": "planar"}


@pytest.mark.parametrize(
    "host", ["evil.example", "127.0.0.1", "evil.example:{port}", "127.0.0.1:1", "localhost:{port}.evil", ""]
)
@pytest.mark.parametrize("path", ["/", "/api/runs", "/runs/unified/report.html", "/api/openapi.json", "/nothing"])
def test_another_host_is_refused(server: Server, host: str, path: str) -> None:
    """A request that names another host, as after DNS rebinding, gets nothing, whatever it asks for."""
    status, _, body = server.ask(path, headers={"Host": host.format(port=server.port)})
    assert (status, json.loads(body)) == (403, {"detail": "this host is not served here"})


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", "https://127.0.0.1:{port}", "http://127.0.0.1", "file://"]
)
@pytest.mark.parametrize("method", ["GET", "POST", "DELETE"])
def test_another_page_is_refused(server: Server, origin: str, method: str) -> None:
    """A request that another page makes is refused, also one that would only read."""
    headers = {"Origin": origin.format(port=server.port), **JSON}
    status, _, body = server.ask("/api/jobs/1", method, json.dumps(ORDER).encode(), headers)
    assert (status, json.loads(body)) == (403, {"detail": "requests of other pages are not served here"})


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost"])
def test_its_own_pages_may_ask(server: Server, name: str) -> None:
    """By both of its names it answers, also where the browser says that the request is its own page's."""
    here = f"{name}:{server.port}"
    assert server.ask("/api/runs", headers={"Host": here, "Origin": f"http://{here}"})[0] == 200


def test_two_hosts_are_none(server: Server) -> None:
    """A request with a second Host line is refused, as nobody knows which one counts."""
    from http.client import HTTPConnection

    connection = HTTPConnection("127.0.0.1", server.port, timeout=10)
    connection.putrequest("GET", "/api/runs")
    connection.putheader("Host", "evil.example")
    connection.endheaders()
    assert connection.getresponse().status in (400, 403)
    connection.close()


@pytest.mark.parametrize("is_chunked", [False, True])
def test_a_large_body_is_refused(server: Server, is_chunked: bool) -> None:
    """Beyond the limit nothing is read on, whether the request says how long it is or not."""
    from http.client import HTTPConnection

    connection = HTTPConnection("127.0.0.1", server.port, timeout=10)
    parts = [b" " * 1000] * (LARGEST_BODY // 1000 + 1)
    connection.request(
        "POST", "/api/jobs", iter(parts) if is_chunked else b"".join(parts), JSON, encode_chunked=is_chunked
    )
    answer = connection.getresponse()
    assert (answer.status, json.loads(answer.read())) == (
        413,
        {"detail": f"the request is larger than {LARGEST_BODY} bytes"},
    )
    connection.close()


@pytest.mark.parametrize("path", ["/", "/studio", "/api/runs", "/assets/list.js"])
def test_pages_run_nothing_but_their_own(server: Server, path: str) -> None:
    """Every answer has a policy that allows this server's scripts alone, and no frame of another page round it."""
    _, headers, _ = server.ask(path)
    policy = headers["content-security-policy"]
    assert "default-src 'none'; script-src 'self';" in policy
    assert "unsafe" not in policy
    assert "frame-ancestors 'self'" in policy
    assert headers["x-content-type-options"] == "nosniff"
    assert "access-control-allow-origin" not in headers
