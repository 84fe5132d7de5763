"""Packed batches: shards that depend on the prompts alone, whole or not there, whoever makes them."""

import functools
import json
import signal
import subprocess
import sys
import tarfile
import time
from importlib.util import find_spec

from harness import BINARY, DEPS, INTERRUPTED, NOT_AS_ASKED, SOURCE, WRONG_INPUT, CliTestCase

KINDS = ("bedroom with a bed", "study with a desk", "kitchen with a fridge")
FILES = ("scene.json", "layout.json", "floorplan.svg", "scene.glb", "report.json")


def prompts(count):
    rooms = [{"id": f"r{i}", "prompt": f"A {KINDS[i % 3]}.", "seed": i + 1} for i in range(count)]
    return "".join(json.dumps(room) + "\n" for room in rooms)


class Packs(CliTestCase):
    def pack(self, text, *options, out="out", size=4):
        file = self.write_text("prompts.jsonl", text)
        return self.run_layoutbox("batch", file, "-o", self.path(out), "--pack", "webdataset", "--shard-size", str(size), "-q", *options)

    def bytes_of(self, out="out"):
        shards = [path for path in self.path(out).glob("shard-*") if not path.name.endswith(".times.jsonl")]
        return {path.name: path.read_bytes() for path in shards}

    def manifest(self, number, out="out"):
        return [json.loads(line) for line in self.path(f"{out}/shard-{number:06}.jsonl").read_text().splitlines()]

    def test_what_a_shard_holds(self):
        self.assert_done(self.pack(prompts(6)))
        names = {path.name for path in self.path("out").iterdir()}
        shards = {f"shard-{n:06}{end}" for n in (0, 1) for end in (".tar", ".jsonl", ".times.jsonl")}
        self.assertEqual(names, {*shards, "summary.json"})
        with tarfile.open(self.path("out/shard-000001.tar")) as tar:
            self.assertEqual(tar.getnames(), [f"{room}.{file}" for room in ("r4", "r5") for file in FILES])
            self.assertTrue(all(member.mtime == 0 and member.uid == 0 for member in tar.getmembers()))
            layout = json.load(tar.extractfile("r4.layout.json"))
            self.assertEqual(layout["stats"]["seconds"], 0)
            self.assertTrue(tar.extractfile("r5.scene.glb").read().startswith(b"glTF"))
        first = self.manifest(1)[0]
        self.assertEqual((first["id"], first["seed"], first["state"], first["offset"]), ("r4", 5, "done", 0))
        self.assertEqual(first["checks"]["failed"], [])
        self.assertEqual(self.manifest(1)[1]["offset"], first["bytes"])

    def test_the_same_bytes_whoever_makes_them(self):
        self.assert_done(self.pack(prompts(10), "-j", "3"))
        for share in ("3/3", "1/3", "2/3"):
            self.assert_done(self.pack(prompts(10), "-j", "1", "--shard", share, out="shared"))
        self.assertEqual(self.bytes_of(), self.bytes_of("shared"))

    def test_what_is_there_is_kept_and_what_is_damaged_made_again(self):
        self.assert_done(self.pack(prompts(10)))
        whole = self.bytes_of()
        damaged = self.path("out/shard-000001.tar")
        content = bytearray(damaged.read_bytes())
        content[5000] ^= 1
        damaged.write_bytes(content)
        self.path("out/shard-000002.tar").write_bytes(whole["shard-000002.tar"][:-512])
        stamp = self.path("out/shard-000000.tar").stat().st_mtime_ns
        self.assert_done(self.pack(prompts(10)))
        self.assertEqual(self.bytes_of(), whole)
        self.assertEqual(self.path("out/shard-000000.tar").stat().st_mtime_ns, stamp)
        self.assertEqual(self.read_json("out/summary.json")["kept"], 4)

    def test_other_options_are_other_shards(self):
        self.assert_done(self.pack(prompts(3)))
        before = self.bytes_of()
        self.assert_done(self.pack(prompts(3), "--detail", "low"))
        self.assertNotEqual(self.bytes_of()["shard-000000.tar"], before["shard-000000.tar"])

    def test_a_line_that_fails_stands_in_the_manifest(self):
        run = self.pack(prompts(1) + '{"id": "none", "prompt": ""}\n' + prompts(3).splitlines()[2] + "\n")
        self.assert_status(run, NOT_AS_ASKED)
        self.assertEqual([line["state"] for line in self.manifest(0)], ["done", "failed", "done"])
        self.assertEqual(self.manifest(0)[1]["bytes"], 0)
        self.assertIn("message", self.manifest(0)[1]["error"])

    def test_ids_that_tar_or_readers_would_cut(self):
        long = "x" * 150
        rooms = [{"id": name, "prompt": "A bedroom with a bed."} for name in ("a.b", "a.c", long)]
        self.assert_done(self.pack("".join(json.dumps(room) + "\n" for room in rooms)))
        with tarfile.open(self.path("out/shard-000000.tar")) as tar:
            keys = {name.split(".")[0] for name in tar.getnames()}
            self.assertEqual({name.split(".", 1)[1] for name in tar.getnames()}, set(FILES))
        self.assertEqual(keys, {line["key"] for line in self.manifest(0)})
        self.assertEqual(len(keys), 3)

    def test_stopped_and_killed_runs_leave_whole_shards_only(self):
        self.assert_done(self.pack(prompts(40), out="whole"))
        whole = self.bytes_of("whole")
        for number, status in ((signal.SIGINT, INTERRUPTED), (signal.SIGKILL, -signal.SIGKILL)):
            with self.subTest(number):
                out = f"out{number}"
                command = ["batch", self.path("prompts.jsonl"), "-o", self.path(out), "--pack", "webdataset", "--shard-size", "4", "-q"]
                process = self.start(*command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                deadline = time.monotonic() + 60
                while not self.path(f"{out}/shard-000001.jsonl").exists() and time.monotonic() < deadline:
                    time.sleep(0.002)
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=60), status)
                for name, content in self.bytes_of(out).items():
                    self.assertEqual(content, whole[name], name)
                self.assert_done(self.pack(prompts(40), out=out))
                self.assertEqual(self.bytes_of(out), whole)

    def test_shares_that_are_none(self):
        for options in (["--shard", "0/3"], ["--shard", "4/3"], ["--shard", "x"], ["--shard", "1/"], ["--pack", "zip"]):
            self.assert_status(self.pack(prompts(1), *options), WRONG_INPUT)
        file = self.write_text("p.jsonl", prompts(1))
        self.assert_status(self.run_layoutbox("batch", file, "-o", self.path("o"), "--shard", "1/2"), WRONG_INPUT)


def needs(module):
    """Runs a case in this Python if it has the module, else in that of `scripts/setup.sh --scale`."""
    python = DEPS / "scale/bin/python"

    def wrapped(case):
        @functools.wraps(case)
        def run(self):
            if find_spec(module):
                case(self)
                return
            if not python.exists():
                self.skipTest(f"{module} is not there: scripts/setup.sh --scale")
            command = [python, SOURCE / "tests/run_case.py", __file__, f"Clusters.{case.__name__}"]
            done = subprocess.run(command, capture_output=True, text=True, timeout=800, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

        return run

    return wrapped


class Clusters(CliTestCase):
    """The scripts of scripts/scale, where what they need is installed."""

    def scale(self, script, *arguments):
        command = [sys.executable, SOURCE / "scripts/scale" / script, *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)

    def setUp(self):
        super().setUp()
        self.file = self.write_text("prompts.jsonl", prompts(10))
        command = ["batch", self.file, "-o", self.path("one"), "--pack", "webdataset", "--shard-size", "2", "-q"]
        self.assert_done(self.run_layoutbox(*command))

    def assert_same_as_one_machine(self, out):
        for path in self.path("one").glob("shard-*"):
            if not path.name.endswith(".times.jsonl"):
                self.assertEqual((out / path.name).read_bytes(), path.read_bytes(), path.name)

    @needs("submitit")
    def test_slurm(self):
        out = self.path("out")
        done = self.scale("slurm_batch.py", self.file, "-o", out, "--shard-size", "2", "--layoutbox", BINARY, "--local", "--jobs", "2")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("5 of 5 shards", done.stdout)
        self.assert_same_as_one_machine(out)

    @needs("ray")
    def test_ray_with_two_nodes_of_which_one_is_lost(self):
        from ray.cluster_utils import Cluster

        cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
        try:
            second = cluster.add_node(num_cpus=1)
            out = self.path("out")
            command = [sys.executable, SOURCE / "scripts/scale/ray_batch.py", self.file, "-o", out, "--shard-size", "2"]
            process = subprocess.Popen(
                [*map(str, command), "--layoutbox", BINARY, "--address", cluster.address], stdout=subprocess.PIPE, stderr=subprocess.PIPE
            )
            deadline = time.monotonic() + 240
            while not list(out.glob("shard-*.jsonl")) and time.monotonic() < deadline and process.poll() is None:
                time.sleep(0.05)
            self.assertTrue(list(out.glob("shard-*.jsonl")), "no shard after four minutes, so nothing could be lost")
            cluster.remove_node(second, allow_graceful=False)
            stdout, stderr = process.communicate(timeout=280)
            self.assertEqual(process.returncode, 0, (stdout + stderr)[-3000:])
            self.assert_same_as_one_machine(out)
        finally:
            cluster.shutdown()

    @needs("pyarrow")
    def test_parquet(self):
        import pyarrow.parquet

        target = self.path("manifest.parquet")
        done = self.scale("manifest_to_parquet.py", self.path("one"), target)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = pyarrow.parquet.read_table(target).to_pylist()
        self.assertEqual([row["id"] for row in rows], [f"r{i}" for i in range(10)])
        self.assertEqual(json.loads(rows[0]["checks"])["failed"], [])
