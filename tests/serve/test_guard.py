"""Pages of other sites, names that lead here from outside, and callers without the token are refused."""

import http.client
import tempfile
import time
from pathlib import Path

from service import Service, ServiceCase


class OwnMachine(ServiceCase):
    def test_foreign_host_name(self):
        answer = self.assert_status(self.service.get("/api/health", host="evil.example:80"), 403)
        self.assertIn("evil.example", answer.json()["message"])

    def test_foreign_origin(self):
        for origin in ("http://evil.example", "null", f"http://127.0.0.1:{self.service.port + 1}"):
            self.assert_status(self.service.post("/api/generate", {"prompt": "a room"}, headers={"Origin": origin}), 403)

    def test_own_origin(self):
        origin = f"http://localhost:{self.service.port}"
        answer = self.service.get("/api/health", headers={"Origin": origin}, host=f"localhost:{self.service.port}")
        self.assert_status(answer, 200)

    def test_what_is_left_unread_is_not_the_next_request(self):
        """A body that comes after its request was refused, or where none belongs, on a connection that is used again."""
        own = {"Host": f"127.0.0.1:{self.service.port}"}
        body = b"{}"
        refused = (("POST", "/api/generate", {"Origin": "http://evil.example"}), ("POST", "/api/plan", {"Range": "none"}))
        for method, path, more in (*refused, ("GET", "/api/health", {}), ("PUT", "/api/health", {})):
            with self.subTest(method=method, path=path):
                connection = http.client.HTTPConnection("127.0.0.1", self.service.port, timeout=60)
                self.addCleanup(connection.close)
                connection.putrequest(method, path, skip_host=True)
                for name, value in {**own, **more, "Content-Length": str(len(body))}.items():
                    connection.putheader(name, value)
                connection.endheaders()
                time.sleep(0.3)
                connection.send(body)
                connection.getresponse().read()
                connection.request("GET", "/api/catalog?search=chair", headers=own)
                self.assertEqual(connection.getresponse().status, 200)


class WithToken(ServiceCase):
    environment = {"LAYOUTBOX_TOKEN": "secret-of-the-test"}

    def test_without_and_with_a_wrong_token(self):
        self.assert_status(self.service.get("/api/health"), 401)
        self.assert_status(self.service.get("/api/health", headers={"Authorization": "Bearer secret-of-the-tesx"}), 401)
        self.assert_status(self.service.get("/?token=wrong"), 401)

    def test_with_the_token(self):
        self.assert_status(self.service.get("/api/health", headers={"Authorization": "Bearer secret-of-the-test"}), 200)

    def test_the_page_gets_a_cookie(self):
        answer = self.assert_status(self.service.get("/?token=secret-of-the-test"), 302)
        cookie = answer.headers["Set-Cookie"]
        self.assertIn("HttpOnly", cookie)
        self.assert_status(self.service.get("/", headers={"Cookie": cookie.split(";")[0]}), 200)


class OtherAddresses(ServiceCase):
    def test_an_open_address_needs_a_token(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(AssertionError, "ended with 2"):
            Service(Path(folder), "--address", "0.0.0.0")

    def test_a_port_that_is_taken(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(AssertionError, "ended with 3"):
            Service(Path(folder), port=self.service.port)
