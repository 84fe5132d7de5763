"""Answers as events: the stages, how far the solver is, and an end to the work where nobody waits for it."""

import http.client
import json
import time

from service import BEDROOM, ServiceCase

LONG = {"prompt": BEDROOM, "effort": 100_000, "timeLimit": 30}


class Streams(ServiceCase):
    def open_stream(self, body):
        connection = http.client.HTTPConnection("127.0.0.1", self.service.port, timeout=120)
        headers = {"Content-Type": "application/json", "Accept": "text/event-stream"}
        connection.request("POST", "/api/generate", json.dumps(body), headers)
        answer = connection.getresponse()
        self.assertEqual(answer.status, 200)
        return connection, answer

    def events(self, answer, until):
        """Names and data up to the first event of a name."""
        found = []
        name = ""
        for line in answer:
            field, _, value = line.decode().rstrip("\n").partition(": ")
            if field == "event":
                name = value
            elif field == "data" and name != "answer":
                found.append((name, value))
            if field == "data" and name == until:
                return found
        raise AssertionError(f"no event {until} after {found}")

    def given_up(self):
        return 'layoutbox_answers_total{operation="generate",status="499"} 1' in self.service.get("/metrics").body.decode()

    def test_stages_and_how_far_it_is(self):
        connection, answer = self.open_stream({"prompt": BEDROOM, "effort": 3000, "variants": 2})
        found = self.events(answer, "answer")
        connection.close()
        self.assertEqual([value for name, value in found if name == "stage"], ["plan", "solve", "verify"])
        shares = [float(value) for name, value in found if name == "progress"]
        self.assertTrue(shares)
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1], 1)

    def test_the_work_ends_with_the_connection(self):
        connection, answer = self.open_stream(LONG)
        self.events(answer, "progress")
        began = time.monotonic()
        answer.close()
        connection.close()
        while not self.given_up() and time.monotonic() - began < 20:
            time.sleep(0.05)
        self.assertTrue(self.given_up(), self.service.get("/metrics").body.decode())
