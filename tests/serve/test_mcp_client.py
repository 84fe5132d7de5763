"""`layoutbox mcp` with the protocol's own Python client."""

import asyncio
import json
import unittest

from service import BEDROOM, BINARY

try:
    from mcp import ClientSession, StdioServerParameters
    from mcp.client.stdio import stdio_client
except ImportError:
    ClientSession = None


def field(value, *names):
    """A member whose name differs between versions of the client."""
    return next(getattr(value, name) for name in names if hasattr(value, name))


@unittest.skipUnless(ClientSession, "the client is missing: scripts/setup.sh --tests")
class ProtocolClient(unittest.TestCase):
    def with_session(self, work):
        async def run():
            async with (
                stdio_client(StdioServerParameters(command=BINARY, args=["mcp"])) as (read, write),
                ClientSession(read, write) as session,
            ):
                await session.initialize()
                return await work(session)

        return asyncio.run(asyncio.wait_for(run(), 120))

    def test_tools_are_listed_with_their_schemas(self):
        async def work(session):
            return (await session.list_tools()).tools

        tools = {tool.name: tool for tool in self.with_session(work)}
        rooms = {f"{verb}_room" for verb in ("generate", "edit", "verify", "judge", "look_at")}
        wanted = {*rooms, "plan_scene", "solve_scene", "move_object", "settle_conflict"}
        self.assertLessEqual(wanted, set(tools))
        for tool in tools.values():
            self.assertEqual(field(tool, "input_schema", "inputSchema")["type"], "object")

    def test_a_room_from_words_to_picture(self):
        async def work(session):
            made = await session.call_tool("generate_room", {"prompt": BEDROOM})
            layout = json.loads(made.content[0].text)["layouts"][0]
            desk = next(item for item in layout["objects"] if item["id"] == "desk_1")
            moved = await session.call_tool(
                "move_object", {"layout": layout, "id": "desk_1", "pos": [desk["pos"][0] - 0.2, desk["pos"][1]]}
            )
            edited = await session.call_tool(
                "edit_room", {"layout": json.loads(moved.content[0].text)["layout"], "text": "remove the lamp"}
            )
            layout = json.loads(edited.content[0].text)["layout"]
            report = await session.call_tool("verify_room", {"layout": layout})
            picture = await session.call_tool("look_at_room", {"layout": layout, "format": "png"})
            return layout, json.loads(report.content[0].text), picture

        layout, report, picture = self.with_session(work)
        self.assertFalse(any(item["category"].endswith("lamp") for item in layout["objects"]))
        self.assertTrue(all(check["passed"] for check in report["checks"] if check["required"]))
        if field(picture, "is_error", "isError"):
            self.skipTest("the library Cairo is missing")
        self.assertEqual(field(picture.content[0], "mime_type", "mimeType"), "image/png")

    def test_planned_solved_judged_and_settled(self):
        prompt = "A room of 4 x 3 m with a table, a chair and a plant. The chair is left of the table. The chair is right of the table."

        async def work(session):
            async def call(tool, **arguments):
                answer = await session.call_tool(tool, arguments)
                self.assertFalse(field(answer, "is_error", "isError"), answer.content[0].text)
                return json.loads(answer.content[0].text)

            scene = (await call("plan_scene", prompt=prompt))["scene"]
            layout = (await call("solve_scene", scene=scene))["layouts"][0]
            ways = (await call("settle_conflict", scene=scene, layout=layout))["ways"]
            settled = (await call("solve_scene", scene=ways[0]["scene"]))["layouts"][0]
            return layout, settled, await call("judge_room", layout=settled, scene=ways[0]["scene"], name="mine")

        layout, settled, judged = self.with_session(work)
        self.assertTrue(layout["conflicts"])
        self.assertFalse(settled.get("conflicts"))
        self.assertEqual(judged["rooms"][0]["name"], "mine")

    def test_a_conflict_is_explained(self):
        scene = {
            "room": {"dims": {"w": 2, "d": 2, "h": 2.5}, "openings": []},
            "furniture": [{"id": f"bed_{i}", "category": "bed", "dims": {"w": 1.6, "d": 2, "h": 0.5}} for i in (1, 2)],
        }

        async def work(session):
            return await session.call_tool("solve_scene", {"scene": scene, "onConflict": "fail"})

        answer = self.with_session(work)
        self.assertTrue(field(answer, "is_error", "isError"))
        self.assertIn("bed", answer.content[0].text)
