"""A server of the chat-completions form that misbehaves on purpose, on raw sockets.

    with FaultServer([status(503), scene_call(SCENE)]) as server:
        run(env={"OPENAI_BASE_URL": server.url})
        server.requests[0].json()["temperature"]

Each request takes the next behaviour; the last one goes on for ever. A behaviour is a function (connection, request) → keep alive?
"""

from __future__ import annotations

import contextlib
import json
import socket
import ssl
import struct
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field

Behaviour = Callable[[socket.socket, "Request"], bool]


@dataclass
class Request:
    """One request as it came."""

    target: str
    headers: dict[str, str]
    body: bytes
    arrived: float = field(default_factory=time.monotonic)

    def json(self) -> dict:
        return json.loads(self.body)

    def last_message(self) -> str:
        return self.json()["messages"][-1]["content"]


class FaultServer:
    """Serves on a free port of this machine, in threads of its own; everything ends with the `with`."""

    def __init__(self, behaviours: list[Behaviour], certificate: tuple[str, str] | None = None) -> None:
        self.behaviours = behaviours
        self.requests: list[Request] = []
        self.connections = 0
        self.stopping = threading.Event()
        self.lock = threading.Lock()
        self.context = None
        if certificate:
            self.context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            self.context.load_cert_chain(*certificate)
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.url = f"{'https' if certificate else 'http'}://127.0.0.1:{self.port}/v1"

    def __enter__(self) -> FaultServer:
        threading.Thread(target=self.accept, daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self.stopping.set()
        self.listener.close()

    def accept(self) -> None:
        while not self.stopping.is_set():
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return
            self.connections += 1
            threading.Thread(target=self.serve, args=(connection,), daemon=True).start()

    def serve(self, connection: socket.socket) -> None:
        with contextlib.suppress(OSError, ssl.SSLError), connection:
            if self.context:
                connection = self.context.wrap_socket(connection, server_side=True)
            while not self.stopping.is_set():
                request = read_request(connection)
                if request is None:
                    return
                with self.lock:
                    self.requests.append(request)
                    behaviour = self.behaviours.pop(0) if len(self.behaviours) > 1 else self.behaviours[0]
                if not behaviour(connection, request):
                    return


def read_request(connection: socket.socket) -> Request | None:
    data = b""
    while b"\r\n\r\n" not in data:
        piece = connection.recv(65536)
        if not piece:
            return None
        data += piece
    head, _, body = data.partition(b"\r\n\r\n")
    first, *lines = head.decode("latin-1").split("\r\n")
    headers = {name.strip().lower(): value.strip() for name, _, value in (line.partition(":") for line in lines)}
    while len(body) < int(headers.get("content-length", 0)):
        body += connection.recv(65536)
    return Request(first.split(" ")[1], headers, body)


# ---- whole answers


def head(status: int, headers: dict[str, str]) -> bytes:
    return (f"HTTP/1.1 {status} X\r\n" + "".join(f"{name}: {value}\r\n" for name, value in headers.items()) + "\r\n").encode()


def raw(status: int, body: bytes | str, content_type: str = "application/json", **headers: str) -> Behaviour:
    data = body.encode() if isinstance(body, str) else body

    def behave(connection: socket.socket, _: Request) -> bool:
        all_headers = {
            "Content-Type": content_type,
            "Content-Length": str(len(data)),
            **{k.replace("_", "-"): v for k, v in headers.items()},
        }
        connection.sendall(head(status, all_headers) + data)
        return True

    return behave


def status(code: int, message: str = "", parameter: str | None = None, error_code: object = None, **headers: str) -> Behaviour:
    error = {"message": message or f"status {code}", "type": "test", "param": parameter, "code": error_code}
    return raw(code, json.dumps({"error": error}), **headers)


def completion(message: dict, finish: str = "stop", usage: dict | None = None) -> dict:
    return {
        "id": "x",
        "object": "chat.completion",
        "choices": [{"index": 0, "message": {"role": "assistant", **message}, "finish_reason": finish}],
        "usage": usage or {"prompt_tokens": 1000, "completion_tokens": 200, "total_tokens": 1200},
    }


def answer(message: dict, finish: str = "stop") -> Behaviour:
    return raw(200, json.dumps(completion(message, finish)))


def call(name: str, arguments: object) -> dict:
    text = arguments if isinstance(arguments, str) else json.dumps(arguments)
    return {"content": None, "tool_calls": [{"id": "c1", "type": "function", "function": {"name": name, "arguments": text}}]}


def scene_call(scene: object) -> Behaviour:
    return answer(call("create_scene", scene), "tool_calls")


def patch_call(patch: object) -> Behaviour:
    return answer(call("patch_scene", {"patch": patch}), "tool_calls")


def content(text: str) -> Behaviour:
    return answer({"content": text})


def scripted(function: Callable[[Request], dict]) -> Behaviour:
    """The message is made from the request."""

    def behave(connection: socket.socket, request: Request) -> bool:
        return raw(200, json.dumps(completion(function(request))))(connection, request)

    return behave


# ---- answers that go wrong


def half_body(connection: socket.socket, _: Request) -> bool:
    body = json.dumps(completion(call("create_scene", {}))).encode()
    connection.sendall(head(200, {"Content-Type": "application/json", "Content-Length": str(len(body))}) + body[: len(body) // 2])
    return False


def no_answer(connection: socket.socket, _: Request) -> bool:
    return False


def reset(connection: socket.socket, _: Request) -> bool:
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    return False


def silence(connection: socket.socket, _: Request) -> bool:
    with contextlib.suppress(OSError):
        connection.recv(1)  # until the other side gives up
    return False


def never_ending(connection: socket.socket, _: Request) -> bool:
    connection.sendall(head(200, {"Content-Type": "application/json", "Transfer-Encoding": "chunked"}))
    with contextlib.suppress(OSError):
        while True:
            connection.sendall(b"1\r\n \r\n")
            time.sleep(0.02)
    return False


def huge(megabytes: int, with_length: bool) -> Behaviour:
    def behave(connection: socket.socket, _: Request) -> bool:
        headers = {"Content-Type": "application/json"}
        if with_length:
            headers["Content-Length"] = str(megabytes << 20)
        else:
            headers["Connection"] = "close"
        with contextlib.suppress(OSError):
            connection.sendall(head(200, headers) + b'{"choices": [{"message": {"content": "')
            for _ in range(megabytes):
                connection.sendall(b"x" * (1 << 20))
        return False

    return behave


def endless(event: bytes) -> Behaviour:
    """A stream of one event again and again, until the other side has had enough."""

    def behave(connection: socket.socket, _: Request) -> bool:
        connection.sendall(head(200, {"Content-Type": "text/event-stream", "Connection": "close"}))
        while True:
            connection.sendall(event * 20)
            time.sleep(0.005)

    return behave


def closing(behaviour: Behaviour) -> Behaviour:
    """Says that the connection stays, and closes it."""

    def behave(connection: socket.socket, request: Request) -> bool:
        behaviour(connection, request)
        return False

    return behave


# ---- streams


def events(message: dict, finish: str = "stop", piece: int = 7) -> bytes:
    """The message as a stream, its texts in pieces of so many characters."""
    out = b": a comment\r\n\r\n"

    def event(delta: dict, end: str | None = None) -> bytes:
        chunk = {"choices": [{"index": 0, "delta": delta, "finish_reason": end}]}
        return b"data: " + json.dumps(chunk, ensure_ascii=False).encode() + b"\n\n"

    out += event({"role": "assistant", "content": ""})
    for index, one in enumerate(message.get("tool_calls", [])):
        function = one["function"]
        out += event(
            {"tool_calls": [{"index": index, "id": "c", "type": "function", "function": {"name": function["name"], "arguments": ""}}]}
        )
        text = function["arguments"]
        for at in range(0, len(text), piece):
            out += event({"tool_calls": [{"index": index, "function": {"arguments": text[at : at + piece]}}]})
    text = message.get("content") or ""
    for at in range(0, len(text), piece):
        out += event({"content": text[at : at + piece]})
    out += event({}, finish)
    out += b'data: {"choices": [], "usage": {"prompt_tokens": 11, "completion_tokens": 22}}\n\n'
    return out + b"data: [DONE]\n\n"


def stream(data: bytes, size: int = 5, cut: int | None = None) -> Behaviour:
    """Sends a stream in packets of so many bytes; cut: only the first so many bytes."""

    def behave(connection: socket.socket, _: Request) -> bool:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.sendall(head(200, {"Content-Type": "text/event-stream", "Connection": "close"}))
        whole = data if cut is None else data[:cut]
        for at in range(0, len(whole), size):
            connection.sendall(whole[at : at + size])
        return False

    return behave
