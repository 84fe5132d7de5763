"""Words for room_sentences.py: things of the catalogue and of WordNet by where they stand, and what goes with them."""

import json
import pathlib
import re

CATALOG = pathlib.Path(__file__).parent.parent / "catalog"
SKIP = {
    "food",
    "object",
    "furniture",
    "seat",
    "device",
    "decoration",
    "appliance",
    "stationery",
    "kitchenware",
    "personal item",
    "clothing",
    "lab equipment",
    "sports equipment",
    "art supply",
    "dual monitors",
    "headphones",
    "binoculars",
    "skis",
    "stairs",
    "cutlery",
    "gallery wall",
    "clay",
    "yarn",
    "soda",
    "paper",
    "sheet music",
    "bread",
    "nesting tables",
    "waiting chairs",
    "track light",
    "string light",
    "bar set",
    "tea set",
    "C-shaped table",
}


def plural(word):
    if word.endswith(("shelf", "knife", "loaf")):
        return re.sub("fe?$", "ves", word)
    if word.endswith(("s", "x", "z", "ch", "sh")):
        return word + "es"
    if word.endswith("y") and word[-2] not in "aeiou":
        return word[:-1] + "ies"
    return {"mouse": "mice", "man": "men", "child": "children"}.get(word, word + "s")


class Thing:
    """A kind of thing: its words, the last of which is the head, and where it stands (floor, small, wall, ceiling, rug)."""

    def __init__(self, words, place, size=1.0):
        self.words, self.place, self.size = words.split(), place, size

    @property
    def name(self):
        return " ".join(self.words)


def catalogue():
    """All things of the catalogue by place; names and synonyms are things of their own."""
    places = {"floor": [], "small": [], "wall": [], "ceiling": [], "rug": []}
    for path in sorted(CATALOG.glob("*.json")):
        for entry in json.loads(path.read_text()).get("entries", []):
            mount = {"surface": "small", "hung": "ceiling", None: "floor"}.get(entry.get("mount"), entry.get("mount"))
            size = entry["size"]
            if "rug" in entry["name"] or entry["name"].split()[-1] == "mat":
                mount = "rug"
            for name in [entry["name"], *entry.get("synonyms", [])]:
                if (
                    name in SKIP
                    or not re.fullmatch(r"[a-z]+( [a-z]+){0,2}", name)
                    or " of " in name
                    or " and " in name
                    or name.endswith("s")
                ):
                    continue
                width = size["w"][1] if isinstance(size["w"], list) else 1.0
                places[mount].append(Thing(name, mount, width))
    return places


def wordnet_things(path=CATALOG / "words_english.txt"):
    """Words that are things and do not end like a plural."""
    lines = (line.split() for line in path.read_text().splitlines())
    return [parts[0] for parts in lines if parts[1] == "t" and re.fullmatch(r"[a-z]{3,11}", parts[0]) and not parts[0].endswith("s")]


ATTRIBUTES = json.loads((CATALOG / "words_attributes.json").read_text())
COLORS = [color for color in json.loads((CATALOG / "colors.json").read_text())["colors"] if re.fullmatch("[a-z]+", color)]
SIZES = [word for word in ATTRIBUTES["size"] if " " not in word]
NOUN_ADJECTIVES = {
    "oak",
    "walnut",
    "pine",
    "mahogany",
    "teak",
    "birch",
    "maple",
    "cherry",
    "ash",
    "bamboo",
    "rattan",
    "wicker",
    "metal",
    "steel",
    "iron",
    "brass",
    "copper",
    "chrome",
    "bronze",
    "aluminum",
    "glass",
    "marble",
    "granite",
    "stone",
    "concrete",
    "ceramic",
    "porcelain",
    "plastic",
    "acrylic",
    "leather",
    "velvet",
    "linen",
    "cotton",
    "fabric",
    "wool",
    "silk",
    "jute",
    "suede",
    "foam",
    "paper",
    "plywood",
    "cardboard",
    "felt",
    "fur",
    "sheepskin",
    "crystal",
    "terracotta",
    "canvas",
    "cane",
    "driftwood",
    "boucle",
    "wood",
    "king",
    "queen",
    "twin",
    "cube",
}
ADJECTIVES = SIZES + [word for key in ("material", "shape", "style") for word in ATTRIBUTES[key] if " " not in word] + COLORS
MOODS = [
    "cozy",
    "comfortable",
    "elegant",
    "stylish",
    "sleek",
    "beautiful",
    "lovely",
    "charming",
    "inviting",
    "plush",
    "simple",
    "neat",
    "bright",
    "dark",
    "soft",
    "warm",
    "decorative",
    "old",
    "new",
    "vintage",
    "antique",
    "rustic",
    "modern",
    "ornate",
    "sturdy",
    "delicate",
    "spacious",
    "fluffy",
    "colorful",
    "functional",
    "unique",
    "heavy",
    "dusty",
    "worn",
]
ROOMS = [
    "bedroom",
    "bathroom",
    "kitchen",
    "office",
    "study",
    "library",
    "playroom",
    "basement",
    "garage",
    "classroom",
    "studio",
    "nursery",
    "gym",
    "hallway",
    "lounge",
    "restaurant",
    "cafe",
    "bar",
    "shop",
    "attic",
    "room",
    "space",
    "apartment",
    "loft",
    "workshop",
    "salon",
    "gallery",
    "cellar",
]
ROOM_COMPOUNDS = (
    "living room",
    "dining room",
    "game room",
    "guest room",
    "laundry room",
    "waiting room",
    "meeting room",
    "master bedroom",
    "home office",
    "hotel room",
    "sun room",
    "music room",
    "children room",
    "conference room",
    "reading room",
    "storage room",
    "family room",
    "studio apartment",
)
