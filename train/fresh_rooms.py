#!/usr/bin/env python3
"""Writes descriptions of random rooms with the scenes they were made from: {"id", "style", "prompt", "objects", "relations"}, a line each.

usage: fresh_rooms.py NUMBER SEED > descriptions.jsonl
The manners are none of those that the parser learned from (room_styles.py) or that rules were written for;
tests/tools/score_descriptions.py compares what `layoutbox plan` makes of them. `objects`: {name: count}.
`relations`: {"kind", "subject", "object"}; objects and subjects are names, or a wall's word, "window", "door", "room"; `said` is false
for what only follows (a mug beside a bowl on the table is on the table).
"""

import argparse
import json
import random

from fresh_styles import STYLES

ROOMS = {
    "bedroom": ("bed", ["wardrobe", "desk", "dresser", "bookshelf", "armchair", "nightstand"]),
    "living room": ("sofa", ["coffee table", "armchair", "bookshelf", "side table", "console table", "piano"]),
    "study": ("desk", ["bookshelf", "armchair", "sideboard"] + ["filing cabinet", "side table"]),
    "dining room": ("dining table", ["sideboard", "bench"] + ["display cabinet", "bar cart", "console table"]),
    "playroom": ("table", ["bookshelf", "bench", "beanbag"] + ["toy chest", "play tent"]),
    "lounge": ("sofa", ["pool table", "bookshelf", "side table", "armchair", "coffee table", "bar cart"]),
    "workshop": ("workbench", ["cabinet", "stool", "ladder"] + ["shelving unit", "side table"]),
}
SURFACES = {
    "desk",
    "dresser",
    "nightstand",
    "coffee table",
    "side table",
    "console table",
    "dining table",
    "sideboard",
    "table",
    "workbench",
    "bench",
}
SMALL = [
    "lamp",
    "vase",
    "mug",
    "bowl",
    "book",
    "clock",
    "plant",
    "candle",
    "laptop",
    "jar",
    "tray",
    "radio",
    "basket",
    "bottle",
    "teapot",
    "notebook",
]
SEATS = {"dining table": "dining chair", "desk": "office chair", "table": "stool", "coffee table": "armchair", "workbench": "stool"}
LOOKS = [
    "small",
    "large",
    "blue",
    "green",
    "red",
    "white",
    "black",
    "wooden",
    "old",
    "modern",
    "round",
    "tall",
    "low",
    "gray",
    "simple",
    "sturdy",
    "vintage",
    "elegant",
    "bright",
    "yellow",
    "metal",
    "glass",
    "oak",
]


class Thing:
    def __init__(self, r, name, number=1):
        self.name, self.number, self.said = name, number, False
        self.look = r.choice(LOOKS) if r.random() < 0.4 else ""


class Again:
    """A thing that the sentence before was about, and nothing else: "it" will do."""

    def __init__(self, thing):
        self.thing = thing

    def __getattr__(self, name):
        return getattr(self.thing, name)


class Scene:
    """Things, and facts (kind, subject, object or word) in the order in which they may be told: a host before what stands on it."""

    def __init__(self, r):
        self.r = r
        self.room = r.choice(sorted(ROOMS))
        main, others = ROOMS[self.room]
        self.things, self.facts = [], []
        anchors = [self.add(main)] + [self.add(name) for name in r.sample(others, r.randint(2, 3))]
        for i, anchor in enumerate(anchors):
            self.place(anchor, anchors[:i])
            if anchor.name in SURFACES:
                self.fill(anchor)
        self.extras(anchors)

    def add(self, name, number=1):
        thing = Thing(self.r, name, number)
        self.things.append(thing)
        return thing

    def place(self, anchor, before):
        r = self.r
        chosen = r.random()
        if before and chosen < 0.45:
            kinds = ("nextTo", "nextTo", "leftOf", "rightOf", "opposite", "inFrontOf" if anchor.name == "coffee table" else "nextTo")
            self.facts.append((r.choice(kinds), anchor, r.choice(before)))
        elif chosen < 0.75:
            self.facts.append(("wall", anchor, r.choice(("left", "right", "back"))))
        elif chosen < 0.87 and not any(kind == "corner" for kind, _, _ in self.facts):
            self.facts.append(("corner", anchor, "room"))
        elif chosen < 0.93 and anchor.name not in {"wardrobe", "bookshelf", "display cabinet"}:
            self.facts.append(("window", anchor, "window"))

    def fill(self, host):
        r = self.r
        free = [name for name in SMALL if not any(thing.name == name for thing in self.things)]
        small = []
        for name in r.sample(free, r.choice((0, 1, 1, 2, 2, 3))):
            thing = self.add(name, r.choice((1, 1, 1, 1, 2, 3)))
            if small and r.random() < 0.5:
                self.facts.append((r.choice(("nextTo", "nextTo", "leftOf", "rightOf", "behind")), thing, r.choice(small)))
            else:
                self.facts.append(("on", thing, host))
            small.append(thing)

    def extras(self, anchors):
        r = self.r
        main = anchors[0]
        seat = SEATS.get(main.name)
        if seat and all(thing.name != seat for thing in self.things) and r.random() < 0.6:
            number = 1 if seat == "office chair" else r.choice((2, 4, 6))
            self.facts.append(("inFrontOf" if number == 1 else "around", self.add(seat, number), main))
        if main.name == "bed" and r.random() < 0.6 and not any(thing.name == "nightstand" for thing in self.things):
            self.facts.append(("sides", self.add("nightstand", 2), main))
        if r.random() < 0.5:
            self.facts.append(("above", self.add(r.choice(("mirror", "painting", "poster"))), r.choice(anchors)))
        if main.name in {"dining table", "table", "desk"} and r.random() < 0.3:
            self.facts.append(("above", self.add("pendant lamp"), main))
        if main.name in {"bed", "sofa", "dining table"} and r.random() < 0.3:
            self.facts.append(("under", self.add("rug"), main))

    def shorten(self, share):
        """Lets some facts say "it": where the fact before placed that thing by a wall or in a corner."""
        for i in range(1, len(self.facts)):
            kind, subject, other = self.facts[i]
            before = self.facts[i - 1]
            if before[1] is other and isinstance(before[2], str) and other.number == 1 and self.r.random() < share:
                self.facts[i] = (kind, subject, Again(other))

    def truth(self):
        """All that holds: what is said, and what stands on what with it."""
        relations, host = [], {}
        for kind, subject, other in self.facts:
            name = other if isinstance(other, str) else other.name
            relations.append({"kind": kind, "subject": subject.name, "object": name, "said": True})
            if kind == "on":
                host[subject.name] = name
            elif name in host and subject.name not in host and subject.name in SMALL:
                host[subject.name] = host[name]
                relations.append({"kind": "on", "subject": subject.name, "object": host[name], "said": False})
        return relations


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("number", type=int)
    parser.add_argument("seed", type=int)
    options = parser.parse_args()
    r = random.Random(options.seed)
    names = sorted(STYLES)
    for i in range(options.number):
        scene = Scene(r)
        style = names[i % len(names)]
        if style not in {"tabletop", "bullets"}:
            scene.shorten(0.5)
        prompt = STYLES[style](r, scene)
        objects = {}
        for thing in scene.things:
            if thing.said:
                objects[thing.name] = objects.get(thing.name, 0) + thing.number
        relations = [each for each in scene.truth() if each["subject"] in objects]
        print(json.dumps({"id": f"{style}{i:03}", "style": style, "prompt": prompt, "objects": objects, "relations": relations}))


if __name__ == "__main__":
    main()
