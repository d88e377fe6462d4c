"""Who may ask, and for how much: what stands between the network and the studio.

The studio listens to this machine alone. Its other danger is a web page that is open in the same browser: it can send
requests here, and by changing what its name resolves to (DNS rebinding) read the answers too. So a request has to name
this server as its host, and where it says which page it comes from, that has to be one of the studio's own.
"""

import asyncio
from collections.abc import Collection
from typing import Final

from starlette.datastructures import Headers
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

LARGEST_BODY: Final = 250_000  # the longest TOML, each of its characters escaped in JSON [byte]
PATIENCE: Final = 10.0  # until a body is here [s]
HEADERS: Final = {
    "content-security-policy": "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "connect-src 'self'; frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'",
    "x-content-type-options": "nosniff",
    "x-frame-options": "SAMEORIGIN",
    "referrer-policy": "no-referrer",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-cache",
}


class Guard:
    """Middleware that answers what is not allowed, and hands on the rest.

    Args:
        app: that is guarded.
        hosts: by which it may be called, such as "127.0.0.1:8000".
    """

    def __init__(self, app: ASGIApp, hosts: Collection[str]) -> None:
        self._app, self._hosts = app, frozenset(hosts)
        self._origins = frozenset(f"http://{host}" for host in hosts)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one request."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        fault = self._fault(Headers(scope=scope))
        if fault:
            await JSONResponse({"detail": fault}, 403)(scope, receive, send)
            return
        try:
            body = await asyncio.wait_for(_body(receive), PATIENCE)
        except TimeoutError:
            await JSONResponse({"detail": "the request was not complete in time"}, 408)(scope, receive, send)
            return
        if body is None:
            fault = f"the request is larger than {LARGEST_BODY} bytes"
            await JSONResponse({"detail": fault}, 413)(scope, receive, send)
            return
        await self._app(scope, _replay(body, receive), _with_headers(send))

    def _fault(self, headers: Headers) -> str:
        host, origin = headers.getlist("host"), headers.getlist("origin")
        if len(host) != 1 or host[0].lower() not in self._hosts:
            return "this host is not served here"
        if any(each.lower() not in self._origins for each in origin) or len(origin) > 1:
            return "requests of other pages are not served here"
        return ""


async def _body(receive: Receive) -> bytes | None:
    """All of it; None where it is too large."""
    body = bytearray()
    while True:
        message = await receive()
        body += message.get("body", b"")
        if len(body) > LARGEST_BODY:
            return None
        if not message.get("more_body", False):
            return bytes(body)


def _replay(body: bytes, receive: Receive) -> Receive:
    """What gives a body that was read, and after it whatever else comes."""
    messages: list[Message] = [{"type": "http.request", "body": body, "more_body": False}]

    async def replayed() -> Message:
        return messages.pop() if messages else await receive()

    return replayed


def _with_headers(send: Send) -> Send:
    async def with_headers(message: Message) -> None:
        if message["type"] == "http.response.start":
            given = {name for name, _ in message["headers"]}
            added = [(name.encode(), value.encode()) for name, value in HEADERS.items()]
            message["headers"] = [*message["headers"], *(each for each in added if each[0] not in given)]
        await send(message)

    return with_headers
