"""A network that misbehaves: each fault has a defined answer, within its time, and the key shows nowhere."""

import contextlib
import json
import resource
import signal
import socket
import subprocess
import time

import fault_server as fault
import model_case
from fault_server import FaultServer, scene_call
from model_case import KEY, SCENE

GOOD = scene_call(SCENE)


class Faults(model_case.ModelCase):
    """What is not asked again, with the words of its error."""

    def assert_refused(self, behaviour, *words, requests=1, status=3, options=()):
        with FaultServer([behaviour]) as server:
            run = self.plan(server, *options)
        self.assert_status(run, status)
        for word in words:
            self.assertIn(word, run.err)
        self.assertEqual(len(server.requests), requests, run.err)
        self.assert_no_key(run)
        self.assertFalse(self.path("scene.json").exists())

    def test_statuses_that_stay(self):
        for code, words in (
            (401, ["key", "OPENAI_API_KEY"]),
            (403, ["allow"]),
            (404, ["model", "LAYOUTBOX_MODEL"]),
            (402, ["402"]),
        ):
            with self.subTest(code):
                self.assert_refused(fault.status(code, f"no, {KEY} is wrong"), str(code), *words)

    def test_nothing_left_to_pay(self):
        self.assert_refused(fault.status(429, "You exceeded your current quota", error_code="insufficient_quota"), "pay")

    def test_a_page_of_a_proxy(self):
        self.assert_refused(fault.raw(200, "<html><body>Please log in</body></html>", "text/html"), "web page")

    def test_a_redirect_is_not_followed(self):
        with FaultServer([GOOD]) as other:
            self.assert_refused(fault.raw(307, "", location=other.url + "/chat/completions"), "elsewhere", other.url)
            self.assertEqual(other.requests, [])

    def test_an_error_in_spite_of_the_status(self):
        body = json.dumps({"error": {"message": "the model is gone", "code": 404}})
        self.assert_refused(fault.raw(200, body), "the model is gone")

    def test_too_long_even_when_short(self):
        """A shorter question is tried, and no more when there is none."""
        for code, words in ((400, "This model's maximum context length is 500 tokens"), (413, "too much")):
            with self.subTest(code), FaultServer([fault.status(code, words)]) as server:
                run = self.plan(server)
                self.assert_status(run, 3)
                self.assertIn("too long", run.err)
                self.assertTrue(2 <= len(server.requests) <= 5, len(server.requests))
                self.assert_no_key(run)

    def test_a_body_that_never_ends(self):
        started = time.monotonic()
        with FaultServer([fault.never_ending]) as server:
            run = self.plan(server, "--model-timeout", "1")
        self.assert_status(run, 3)
        self.assertLess(time.monotonic() - started, 30)

    def test_fifty_megabytes(self):
        for with_length in (True, False):
            with self.subTest(with_length):
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
                self.assert_refused(fault.huge(50, with_length), "larger than")
                self.assertLess(max(before, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss), 100 * 1024)

    def test_nobody_there(self):
        with socket.create_server(("127.0.0.1", 0)) as listener:
            port = listener.getsockname()[1]
        run = self.plan(f"http://127.0.0.1:{port}/v1")
        self.assert_status(run, 3)
        self.assertIn("nothing answers", run.err)

    def test_a_name_without_an_address(self):
        run = self.plan("http://no-such-host.invalid/v1")
        self.assert_status(run, 3)
        self.assertIn("no address", run.err)

    def test_a_certificate_of_ones_own(self):
        certificate, key = self.path("cert.pem"), self.path("key.pem")
        command = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", key, "-out", certificate, "-days", "2"]
        command += ["-subj", "/CN=127.0.0.1", "-addext", "subjectAltName=IP:127.0.0.1"]
        if subprocess.run(command, capture_output=True, check=False).returncode != 0:
            self.skipTest("no openssl here")
        with FaultServer([GOOD], (certificate, key)) as server:
            run = self.plan(server)
            self.assert_status(run, 3)
            self.assertIn("no safe connection", run.err)
            self.assertEqual(server.requests, [])
            self.assert_done(self.plan(server, env={"SSL_CERT_FILE": certificate}))

    def test_no_key_for_the_hosted_server(self):
        run = self.plan("https://api.openai.com/v1", env={"OPENAI_API_KEY": None})
        self.assert_status(run, 3)
        self.assertIn("OPENAI_API_KEY", run.err)

    def test_addresses_that_are_none(self):
        for address in ("ftp://x/v1", "no address", "http://", "http://user:secret@127.0.0.1/v1"):
            with self.subTest(address):
                run = self.plan(address)
                self.assert_status(run, 2)
                self.assertNotIn("secret", run.err)


class Retries(model_case.ModelCase):
    """What is asked again, and then answered."""

    def assert_mended(self, *behaviours, requests=None):
        with FaultServer([*behaviours, GOOD]) as server:
            run = self.plan(server)
        self.assert_done(run)
        self.assertEqual(len(server.requests), requests or len(behaviours) + 1)
        self.assert_no_key(run)
        return server

    def test_statuses_that_pass(self):
        for code in (408, 409, 429, 500, 502, 503, 504):
            with self.subTest(code):
                self.assert_mended(fault.status(code, retry_after_ms="10"))
                self.path("cache").rename(self.path(f"cache {code}"))

    def test_the_server_says_when(self):
        server = self.assert_mended(fault.status(429, Retry_After="1"))
        self.assertGreaterEqual(server.requests[1].arrived - server.requests[0].arrived, 1.0)

    def test_too_long_a_wait_is_not_begun(self):
        with FaultServer([fault.status(503, Retry_After="86400")]) as server:
            run = self.plan(server)
        self.assert_status(run, 3)
        self.assertIn("86400", run.err)

    def test_half_a_body(self):
        self.assert_mended(fault.half_body)

    def test_a_reset_connection(self):
        self.assert_mended(fault.reset)

    def test_an_empty_body(self):
        self.assert_mended(fault.raw(200, ""))

    def test_bytes_that_are_no_text(self):
        self.assert_mended(fault.raw(200, b'{"choices": [{"message": {"content": "\xff\xfe"}}]}'))

    def test_no_choices(self):
        self.assert_mended(fault.raw(200, '{"choices": []}'))

    def test_keep_alive_that_the_server_closes(self):
        """The second question goes over a connection that is gone."""
        with FaultServer([fault.closing(fault.content("no scene")), GOOD]) as server:
            self.assert_done(self.plan(server))
        self.assertEqual(server.connections, 2)

    def test_a_connection_is_kept(self):
        with FaultServer([fault.content("no scene"), GOOD]) as server:
            self.assert_done(self.plan(server))
        self.assertEqual(server.connections, 1)

    def test_gives_up_in_the_end(self):
        with FaultServer([fault.status(503, "tired", retry_after_ms="1")]) as server:
            run = self.plan(server)
        self.assert_status(run, 3)
        self.assertEqual(len(server.requests), 6)
        self.assertIn("asked 6 times", run.err)
        self.assertIn("tired", run.err)


class Streams(model_case.ModelCase):
    """Answers in pieces, split anywhere."""

    DATA = fault.events(
        fault.call("create_scene", json.dumps({**SCENE, "metadata": {"roomType": "bedroom", "name": "Größe 📐"}}, ensure_ascii=False))
    )

    def test_pieces_of_any_size(self):
        for size in (1, 3, 64, 100_000):
            with self.subTest(size), FaultServer([fault.stream(self.DATA, size)]) as server:
                self.assert_done(self.plan(server, "--stream", "--no-cache"))
                self.assertTrue(server.requests[0].json()["stream"])

    def test_other_line_ends(self):
        for end in (b"\r\n", b"\r"):
            with self.subTest(end), FaultServer([fault.stream(self.DATA.replace(b"\r\n", b"\n").replace(b"\n", end), 1000)]) as server:
                self.assert_done(self.plan(server, "--stream", "--no-cache"))

    def test_a_stream_that_nobody_asked_for(self):
        with FaultServer([fault.stream(self.DATA, 1000)]) as server:
            self.assert_done(self.plan(server))

    def test_a_cut_stream_is_asked_again(self):
        for cut in (10, len(self.DATA) // 2, self.DATA.index(b'"finish_reason": "stop"') - 40):
            with self.subTest(cut), FaultServer([fault.stream(self.DATA, 1000, cut), fault.stream(self.DATA, 1000)]) as server:
                self.assert_done(self.plan(server, "--stream", "--no-cache"))
                self.assertEqual(len(server.requests), 2)


class Stopping(model_case.ModelCase):
    """Ctrl-C ends within a second, whatever the server does."""

    def assert_stops(self, url, *more):
        arguments = ["plan", "A bedroom with a bed.", "--planner", "llm", *more]
        process = self.start(*arguments, env=self.environment(url), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.7)
        sent = time.monotonic()
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=20)
        self.assertLess(time.monotonic() - sent, 1.0)
        self.assertEqual(process.returncode, 130, said)

    def test_while_nothing_comes(self):
        with FaultServer([fault.silence]) as server:
            self.assert_stops(server.url)

    def test_while_connecting(self):
        with contextlib.ExitStack() as stack:
            deaf = stack.enter_context(socket.socket())
            deaf.bind(("127.0.0.1", 0))
            deaf.listen(0)  # with its queue full the next connection is never accepted
            for _ in range(4):
                waiting = stack.enter_context(socket.socket())
                waiting.setblocking(False)
                waiting.connect_ex(deaf.getsockname())
            self.assert_stops(f"http://127.0.0.1:{deaf.getsockname()[1]}/v1")

    def test_in_the_pause_between_attempts(self):
        with FaultServer([fault.scene_call({"room": "none"})]) as server:
            self.assert_stops(server.url, "--attempt-pause", "30")

    def test_while_a_body_trickles(self):
        with FaultServer([fault.never_ending]) as server:
            self.assert_stops(server.url)

    def test_between_two_tries(self):
        with FaultServer([fault.status(503, Retry_After="30")]) as server:
            self.assert_stops(server.url)
