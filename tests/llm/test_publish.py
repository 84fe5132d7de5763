"""Pictures by address: a real S3 server (moto), a Cloudinary that checks signatures, a server that takes PUT. No credential shows
anywhere."""

import hashlib
import json
import os
import re
import socket
import subprocess
import threading
import time
import unittest
import urllib.request
from email.parser import BytesParser
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import model_case
from fault_server import call, completion
from harness import DEPS, DONE, WRONG_INPUT, WRONG_SURROUNDINGS
from test_vision import ROOM

MOTO = DEPS / "store/bin/moto_server"
SECRETS = {
    "AWS_ACCESS_KEY_ID": "AKIAPUBLISHTEST0001",
    "AWS_SECRET_ACCESS_KEY": "aws+secret/of-the-test-0123456789",
    "CLOUDINARY_URL": "cloudinary://384921:cloudinary-secret-77@our-cloud",
    "LAYOUTBOX_PUT_HEADER": "Authorization: Bearer put-secret-0815",
}
STORE = """
import boto3, json, sys
def client(name):
    return boto3.client(name, endpoint_url=sys.argv[1], region_name="us-east-1", aws_access_key_id="x", aws_secret_access_key="y",
                        config=boto3.session.Config(retries={"max_attempts": 10, "mode": "standard"}))
iam = client("iam")
iam.create_user(UserName="us")
key = iam.create_access_key(UserName="us")["AccessKey"]
may = {"Version": "2012-10-17", "Statement": [{"Effect": "Allow", "Action": "s3:*", "Resource": "*"}]}
iam.put_user_policy(UserName="us", PolicyName="all", PolicyDocument=json.dumps(may))
client("s3").create_bucket(Bucket="our-rooms")
print(json.dumps({"AWS_ACCESS_KEY_ID": key["AccessKeyId"], "AWS_SECRET_ACCESS_KEY": key["SecretAccessKey"]}))
"""
PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c49444154789c63f8cfc000000301010018dd8db00000000049454e44ae426082"
)


class Server:
    """An HTTP server on a port of its own; `handler` gets (method, path, headers, body) and gives (status, type, body)."""

    def __init__(self, handler):
        outer = self
        self.requests = []

        class Handler(BaseHTTPRequestHandler):
            def answer(self):
                body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
                outer.requests.append((self.command, self.path, dict(self.headers), body))
                status, kind, data = handler(self.command, self.path, self.headers, body)
                self.send_response(status)
                self.send_header("Content-Type", kind)
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                self.wfile.write(data)

            do_GET = do_POST = do_PUT = answer

            def log_message(self, *_):
                pass

        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.port = self.server.server_port
        self.address = f"http://127.0.0.1:{self.port}"
        self.url = self.address + "/v1"

    def __enter__(self):
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()


class Model(Server):
    """A vision model that fetches the picture, as a hosted one would."""

    def __init__(self, before=None):
        self.fetched, self.before = [], before
        super().__init__(self.judge)

    def judge(self, _method, _path, _headers, body):
        asked = json.loads(body)
        url = next(part["image_url"]["url"] for part in asked["messages"][-1]["content"] if part["type"] == "image_url")
        if self.before:
            self.before()
        # Names below localhost are this machine for the program, but not for every resolver.
        host = url.split("/")[2]
        near = urllib.request.Request(url.replace(host, "127.0.0.1:" + host.split(":")[1], 1), headers={"Host": host})
        with urllib.request.urlopen(near, timeout=20) as response:
            self.fetched.append((url, response.read()))
        name = asked["tools"][0]["function"]["name"]
        said = {"score": 0.5, "reason": ""} if name == "score" else {"answer": "yes", "reason": ""}
        return 200, "application/json", json.dumps(completion(call(name, said))).encode()


class Cloudinary(Server):
    """Takes signed uploads only, and gives back what it has."""

    def __init__(self, secret="cloudinary-secret-77"):
        self.files, self.secret = {}, secret
        super().__init__(self.take)

    def take(self, method, path, headers, body):
        if method == "GET":
            return 200, "image/png", self.files[path.rsplit("/", 1)[1]]
        fields = {}
        whole = BytesParser().parsebytes(b"Content-Type: " + headers["Content-Type"].encode() + b"\r\n\r\n" + body)
        for part in whole.get_payload():
            fields[part.get_param("name", header="content-disposition")] = part.get_payload(decode=True)
        signed = "&".join(f"{name}={fields[name].decode()}" for name in sorted(fields) if name not in ("file", "api_key", "signature"))
        if fields["signature"].decode() != hashlib.sha1((signed + self.secret).encode()).hexdigest():
            said = {"error": {"message": "Invalid Signature. String to sign - '" + signed + "', key 384921"}}
            return 401, "application/json", json.dumps(said).encode()
        assert path == "/v1_1/our-cloud/image/upload" and abs(int(fields["timestamp"]) - time.time()) < 600
        name = fields["public_id"].decode().rsplit("/", 1)[1] + ".png"
        self.files[name] = fields["file"]
        return 200, "application/json", json.dumps({"secure_url": f"{self.address}/our-cloud/{name}"}).encode()


class Folder(Server):
    """Takes files by PUT from who has the token."""

    def __init__(self):
        self.files = {}
        super().__init__(self.take)

    def take(self, method, path, headers, body):
        if method == "GET":
            return 200, "image/png", self.files[path]
        if headers.get("Authorization") != "Bearer put-secret-0815":
            return 403, "text/plain", b"no: " + headers.get("Authorization", "").encode()
        self.files[path] = body
        return 201, "text/plain", b""


class Publish(model_case.ModelCase):
    def setUp(self):
        super().setUp()
        self.path("room").mkdir()
        self.room = self.write_json("room/layout.json", ROOM)
        self.path("room/scene.png").write_bytes(PNG)

    def judge(self, by, model, env, *more):
        options = ["--by", "vlm", "--publish", by, "--json", "--singles", "1", "--multis", "0", *more]
        return self.run_layoutbox("judge", self.room, *options, env=self.environment(model, **env))

    def published(self, by, env, before=None):
        with Model(before) as model:
            run = self.judge(by, model, env, "--no-cache")
            self.assert_status(run, DONE)
            self.assertTrue(model.fetched)
            self.assertTrue(all(data == PNG for _, data in model.fetched))
            self.assert_hidden(run)
            return model.fetched[0][0]

    def assert_hidden(self, run):
        self.assert_no_key(run)
        kept = b"".join(path.read_bytes() for path in self.folder.rglob("*") if path.is_file() and path.name != "credentials")
        for value in SECRETS.values():
            for secret in re.findall(r"[\w/+-]{6,}", value.split("//")[-1].split("@")[0].removeprefix("Authorization: Bearer")):
                self.assertNotIn(secret, run.out + run.err)
                self.assertNotIn(secret.encode(), kept)
        self.assertNotIn(b"X-Amz-Signature", kept)

    def test_put(self):
        with Folder() as folder:
            env = {"LAYOUTBOX_PUT_URL": folder.address + "/rooms/", "LAYOUTBOX_PUT_HEADER": SECRETS["LAYOUTBOX_PUT_HEADER"]}
            self.assertRegex(self.published("put", env), r"/rooms/[0-9a-f]{16}\.png$")
            with Model() as model:
                run = self.judge("put", model, {**env, "LAYOUTBOX_PUT_HEADER": "Authorization: Bearer other-secret-1"}, "--no-cache")
            self.assert_status(run, WRONG_SURROUNDINGS)
            self.assertIn("403", run.err)
            self.assertNotIn("other-secret-1", run.err)

    def test_cloudinary(self):
        with Cloudinary() as cloud:
            env = {"CLOUDINARY_URL": SECRETS["CLOUDINARY_URL"], "LAYOUTBOX_CLOUDINARY_ENDPOINT": cloud.address}
            self.assertIn("/our-cloud/", self.published("cloudinary", env))
        with Cloudinary("another") as cloud, Model() as model:
            run = self.judge("cloudinary", model, {**env, "LAYOUTBOX_CLOUDINARY_ENDPOINT": cloud.address}, "--no-cache")
            self.assert_status(run, WRONG_SURROUNDINGS)
            self.assertIn("Invalid Signature", run.err)
            self.assert_hidden(run)

    def test_a_file_that_others_may_read_is_not_used(self):
        file = self.write_text("credentials", f"# ours\nCLOUDINARY_URL = {SECRETS['CLOUDINARY_URL']}\n")
        env = {"LAYOUTBOX_CREDENTIALS": file}
        os.chmod(file, 0o644)
        with Cloudinary() as cloud:
            env["LAYOUTBOX_CLOUDINARY_ENDPOINT"] = cloud.address
            with Model() as model:
                run = self.judge("cloudinary", model, env)
            self.assert_status(run, WRONG_SURROUNDINGS)
            self.assertIn("chmod 600", run.err)
            os.chmod(file, 0o600)
            self.published("cloudinary", env)

    def test_what_is_missing_is_named(self):
        with Model() as model:
            run = self.judge("s3", model, {"LAYOUTBOX_S3_BUCKET": "rooms"})
            self.assert_status(run, WRONG_INPUT)
            self.assertIn("AWS_ACCESS_KEY_ID", run.err)
            run = self.judge("put", model, {"LAYOUTBOX_PUT_URL": "http://example.org/rooms"})
            self.assert_status(run, WRONG_INPUT)
            self.assertIn("https://", run.err)

    @unittest.skipUnless(MOTO.exists(), "no moto: scripts/setup.sh --tests")
    def test_s3(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        address = f"http://127.0.0.1:{port}"
        # After the four steps of its set-up it checks the signature of every upload.
        environment = {**os.environ, "INITIAL_NO_AUTH_ACTION_COUNT": "4"}
        moto = subprocess.Popen([MOTO, "-p", str(port)], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(moto.wait)
        self.addCleanup(moto.terminate)
        made = subprocess.run([MOTO.with_name("python"), "-c", STORE, address], capture_output=True, text=True, timeout=120, check=True)
        SECRETS.update(json.loads(made.stdout))
        keys = {name: SECRETS[name] for name in ("AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY")}
        env = {**keys, "LAYOUTBOX_S3_BUCKET": "our-rooms", "LAYOUTBOX_S3_ENDPOINT": address, "AWS_REGION": "us-east-1"}
        with Model() as model:
            run = self.judge("s3", model, {**env, "AWS_SECRET_ACCESS_KEY": "a-wrong-secret-0123456789"})
            self.assert_status(run, WRONG_SURROUNDINGS)
            self.assertIn("signature", run.err)
            self.assertNotIn("a-wrong-secret", run.err)
            self.assert_hidden(run)

        def trust():  # it cannot check addresses; signature_v4_test does
            ask = urllib.request.Request(f"{address}/moto-api/reset-auth", b"1000000", {"Content-Type": "text/plain"})
            urllib.request.urlopen(ask, timeout=20).close()

        for style, begin in (("path", f"{address}/our-rooms/layoutbox/"), ("virtual", f"http://our-rooms.localhost:{port}/layoutbox/")):
            endpoint = address if style == "path" else f"http://localhost:{port}"
            url = self.published("s3", {**env, "LAYOUTBOX_S3_STYLE": style, "LAYOUTBOX_S3_ENDPOINT": endpoint}, trust)
            self.assertTrue(url.startswith(begin), url)
            self.assertIn("X-Amz-Expires=3600", url)


if __name__ == "__main__":
    unittest.main()
