"""--config: options from a file, TOML or JSON, that the command line beats."""

from harness import WRONG_INPUT, CliTestCase

PROMPT = "A bedroom with a bed and a wardrobe."


class ConfigFiles(CliTestCase):
    def options(self, text, *arguments, command="generate", name="config.toml"):
        """The options of the run as run.json has them."""
        config = self.write_text(name, text)
        self.assert_done(self.run_layoutbox(command, PROMPT, "-o", self.path("out"), "--config", config, *arguments))
        return self.read_json("out/run.json")["options"]

    def test_toml(self):
        options = self.options('# mine\nseed = 7\nroom = "5x4x2.6"\nno-render = true\nquality = "draft"\n')
        self.assertEqual((options["seed"], options["room"], options["pictures"], options["quality"]), (7, [5, 4, 2.6], False, "draft"))

    def test_json(self):
        options = self.options(
            '{"seed": 7, "room": "5x4x2.6", "no-render": true, "views": ["top", "iso"], "effort": null}', name="config.json"
        )
        self.assertEqual((options["seed"], options["room"], options["views"]), (7, [5, 4, 2.6], ["top", "iso"]))

    def test_the_command_line_beats_it(self):
        options = self.options("seed = 7\neffort = 50\nno-render = true\n", "--seed", "8")
        self.assertEqual((options["seed"], options["effort"]), (8, 50))

    def test_one_file_for_all_commands(self):
        text = "seed = 7\nno-render = true\nforce = true\njobs = 1\n[batch]\nseed = 9\n[generate]\neffort = 60\n"
        options = self.options(text)
        self.assertEqual((options["seed"], options["effort"]), (7, 60))
        solved = self.run_layoutbox("solve", self.path("out/scene.json"), "-o", self.path("l.json"), "--config", self.path("config.toml"))
        self.assert_done(solved)
        self.assertEqual(self.read_json("l.json")["stats"]["seed"], 7)
        prompts = self.write_text("p.txt", PROMPT)
        self.assert_done(self.run_layoutbox("batch", prompts, "-o", self.path("b"), "--config", self.path("config.toml")))
        self.assertEqual(self.read_json("b/0001/run.json")["options"]["seed"], 9)

    def test_mistakes(self):
        for text, word in (
            ("sede = 7\n", "sede"),
            ('{"seed": {"a": 1}}', "seed"),
            ('{"seed": 7,}', "config"),
            ('seed = "many"\n', "seed"),
            ("[generat]\nseed = 7\n", "generat"),
            ("effort = 0\n", "effort"),
        ):
            with self.subTest(text):
                config = self.write_text("bad", text)
                run = self.run_layoutbox("generate", PROMPT, "--no-render", "-o", self.path("out"), "--config", config)
                self.assert_status(run, WRONG_INPUT)
                self.assertIn(word, run.err.lower())
                self.assertFalse(self.path("out").exists())

    def test_missing_file(self):
        run = self.run_layoutbox("generate", PROMPT, "--no-render", "-o", self.path("out"), "--config", self.path("nowhere"))
        self.assert_status(run, WRONG_INPUT)
        self.assertIn("nowhere", run.err)
