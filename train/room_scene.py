"""Random rooms: things, and facts of who stands where to what, for room_sentences.py."""

from room_words import Thing, catalogue, wordnet_things

PLACES = catalogue()
OTHERS = wordnet_things()
COMMON = {
    "floor": (
        "bed, sofa, table, desk, chair, armchair, bookshelf, dresser, wardrobe, nightstand, cabinet, bench, lamp, sideboard, "
        "stool, plant, couch, ottoman, shelf, counter, dining table, coffee table, floor lamp, side table, potted plant, tv "
        "stand, office chair, console table, mini fridge, display cabinet"
    ),
    "small": (
        "lamp, vase, book, laptop, mug, cup, bowl, plate, tray, jar, candle, clock, monitor, keyboard, plant, phone, pillow, "
        "glass, bottle, toy, basket, radio, table lamp, desk lamp, picture frame, coffee maker, photo frame, fruit bowl, board "
        "game, alarm clock, tissue box"
    ),
    "wall": (
        "mirror, painting, clock, shelf, poster, tv, photograph, picture, map, whiteboard, calendar, sconce, wall lamp, wall "
        "clock, bulletin board"
    ),
    "ceiling": "chandelier, lamp, light, fan, pendant light, pendant lamp, ceiling fan",
    "rug": "rug, carpet, mat, area rug, wool rug, play mat",
}
COMMONS = {place: [Thing(words, place) for words in names.split(", ")] for place, names in COMMON.items()}


def pick(r, place):
    chosen = r.random()
    if chosen < 0.45:
        return r.choice(COMMONS[place])
    if chosen < 0.9 or place == "rug":
        return r.choice(PLACES[place] or COMMONS[place])
    word = r.choice(OTHERS)
    return Thing(word if r.random() < 0.7 else f"{r.choice(OTHERS)} {word}", place)


class Item:
    """Things of one kind that the text speaks of together."""

    def __init__(self, thing, number):
        self.thing, self.number, self.said = thing, number, False


class Fact:
    """`subject` stands by `kind` to `other` (None: to the room)."""

    def __init__(self, subject, kind, other=None):
        self.subject, self.kind, self.other, self.used = subject, kind, other, False


class Scene:
    def __init__(self, r, catalogue_only=False):
        self.r, self.items, self.facts = r, [], []
        self.names = set()
        self.catalogue_only = catalogue_only
        anchors = [self.item("floor") for _ in range(r.randint(2, 4))]
        for i, anchor in enumerate(anchors):
            if i and r.random() < 0.5:
                self.facts.append(Fact(anchor, "beside", r.choice(anchors[:i])))
            elif r.random() < 0.8:
                self.facts.append(Fact(anchor, "room"))
            self.on_top(anchor)
        if r.random() < 0.4:
            self.facts.append(Fact(self.item("floor", r.choice((2, 3, 4, 4, 6))), "around", anchors[0]))
        if r.random() < 0.4:
            self.facts.append(Fact(self.item("floor", 2), "sides", r.choice(anchors)))
        if r.random() < 0.5:
            self.facts.append(Fact(self.item("wall"), r.choice(("above", "wall")), r.choice(anchors)))
        if r.random() < 0.35:
            self.facts.append(Fact(self.item("ceiling"), r.choice(("above", "ceiling")), r.choice(anchors)))
        if r.random() < 0.35:
            self.facts.append(Fact(self.item("rug"), r.choice(("under", "room")), r.choice(anchors)))
        for fact in self.facts:
            if fact.kind in {"room", "wall", "ceiling"}:
                fact.other = None

    def on_top(self, anchor):
        r, small = self.r, []
        if anchor.number != 1:
            return
        for _ in range(r.choice((0, 0, 1, 1, 2, 3))):
            item = self.item("small")
            if small and r.random() < 0.5:
                self.facts.append(Fact(item, "beside", r.choice(small)))
            else:
                self.facts.append(Fact(item, "on", anchor))
            small.append(item)

    def item(self, place, number=None):
        r = self.r
        for _ in range(50):
            thing = pick(r, place)
            if thing.words[-1] not in self.names:
                break
        self.names.add(thing.words[-1])
        if number is None:
            number = r.choice((1, 1, 1, 1, 1, 1, 2, 2, 3, 0))
        item = Item(thing, number)
        self.items.append(item)
        return item

    def take(self, item=None, as_other=None, kinds=None):
        """An unused fact about an item, or about what stands by it; None if there is none."""
        found = [
            fact
            for fact in self.facts
            if not fact.used
            and (item is None or fact.subject is item)
            and (as_other is None or fact.other is as_other)
            and (kinds is None or fact.kind in kinds)
        ]
        if not found:
            return None
        fact = self.r.choice(found)
        fact.used = True
        return fact
