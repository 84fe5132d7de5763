"""Noun phrases and places as trees, for room_sentences.py. All take the random source `r` first."""

from room_words import ADJECTIVES, COLORS, MOODS, NOUN_ADJECTIVES, ROOM_COMPOUNDS, ROOMS, plural
from tree_text import Node, prep

NUMBERS = ("two", "three", "four", "five", "six", "seven", "eight", "ten", "twelve")
HYPHENED = (
    ("wall", "NN", "npadvmod", "mounted", "VBN"),
    ("king", "NN", "compound", "size", "NN"),
    ("queen", "NN", "compound", "sized", "VBN"),
    ("l", "NN", "npadvmod", "shaped", "VBN"),
    ("marble", "NN", "npadvmod", "topped", "VBN"),
    ("high", "JJ", "amod", "backed", "VBN"),
    ("low", "JJ", "amod", "profile", "NN"),
    ("three", "CD", "nummod", "seater", "NN"),
    ("full", "JJ", "amod", "length", "NN"),
    ("floor", "NN", "npadvmod", "standing", "VBG"),
    ("mid", "JJ", "amod", "century", "NN"),
    ("free", "JJ", "advmod", "standing", "VBG"),
)


def det_for(word):
    return "an" if word == "l" or word[0] in "aeiou" and word != "u" and not word.startswith(("uni", "one", "euro")) else "a"


def adjective(word):
    if word in NOUN_ADJECTIVES:
        return "compound", Node(word, "NN")
    if word.endswith("ed") and word not in {"red"}:
        return "amod", Node(word, "VBN")
    return "amod", Node(word, "JJ")


def hyphened(r):
    first, first_tag, arc, second, tag = r.choice(HYPHENED)
    head = Node(second, tag, glued=r.random() < 0.7)
    head.left(arc, Node(first, first_tag))
    return ("compound" if tag == "NN" else "amod"), head


def adjectives(r, most=2):
    """Zero to `most` modifiers, with commas now and then."""
    number = r.choice((0, 0, 0, 1, 1, 1, 2, 2, 3)[: 3 * most + 0] or (0,))
    words = [r.choice(r.choice((ADJECTIVES, COLORS, MOODS))) for _ in range(number)]
    result = [adjective(word) for word in words]
    if result and r.random() < 0.12:
        result[r.randrange(len(result))] = hyphened(r)
    if len(result) > 1 and r.random() < 0.25 and all(arc == "amod" for arc, _ in result[:2]):
        result.insert(1, ("punct", Node(",", "PUNCT")))
    elif result and r.random() < 0.05 and result[0][0] == "amod":
        result.insert(0, ("advmod", Node(r.choice(("very", "rather", "really", "quite")), "RB")))
        adverb = result.pop(0)[1]
        result[0][1].first("advmod", adverb)
    return result


def heads(r, thing, many):
    """The noun with its compound words."""
    *before, last = thing.words
    head = Node(plural(last) if many else last, "NNS" if many else "NN")
    for word in before:
        head.left("compound", Node(word, "NN"))
    return head


def measure(r):
    """ "60 inch", "4x6 ft", "2 meter" before a noun."""
    unit = Node(r.choice(("inch", "cm", "ft", "foot", "m", "meter")), "NN", glued=r.random() < 0.3)
    number = Node(str(r.choice((r.randint(2, 9), r.randint(20, 200)))), "CD")
    if r.random() < 0.4:
        number.left("quantmod", Node(str(r.randint(2, 12)), "CD")).left("punct", Node("x", "SYM"))
    unit.left("nummod", number)
    return unit


def noun(r, thing, number=1, definite=False, plain=False):
    """The phrase of a thing; `number` 0 is "some, several, …". Returns the node that stands for the whole."""
    many = number != 1
    head = heads(r, thing, many)
    modifiers = [] if plain or (definite and r.random() < 0.75) else adjectives(r)
    for arc, node in reversed(modifiers):
        head.first(arc, node)
    if not definite and r.random() < 0.04:
        head.first("compound" if not head.before else "nmod", measure(r))
    if definite:
        if number > 1 and r.random() < 0.25:
            head.first("nummod", Node(NUMBERS[min(number, 10) - 2], "CD"))
        head.first("det", Node("the", "DT"))
        return head
    if number == 1:
        chosen = r.random()
        if chosen < 0.08:
            head.first("nummod", Node(r.choice(("one", "1")), "CD"))
        elif chosen < 0.11:
            head.first("amod", Node("single", "JJ")).first("det", Node("a", "DT"))
        elif chosen < 0.13:
            head.first("det", Node("another", "DT"))
        else:
            first = head.words()[0][0].word
            head.first("det", Node(det_for(first), "DT"))
        return head
    if number == 0:
        return vague(r, head)
    chosen = r.random()
    if chosen < 0.08:
        return group(r, head, r.choice(("pair",) if number == 2 else ("set", "group", "row", "cluster")), number)
    word = NUMBERS[min(number, 10) - 2] if r.random() < 0.75 else str(number)
    head.first("nummod", Node(word, "CD"))
    return head


def vague(r, head):
    chosen = r.random()
    if chosen < 0.3:
        head.first("amod", Node(r.choice(("several", "various", "many")), "JJ"))
    elif chosen < 0.5:
        head.first("det", Node("some", "DT"))
    elif chosen < 0.65:
        head.first("amod", Node("few", "JJ")).first("det", Node("a", "DT"))
    elif chosen < 0.8:
        return group(r, head, r.choice(("collection", "stack", "row", "set", "couple", "bunch", "number", "pile")), 0)
    return head


def group(r, head, word, number):
    if number > 2 or (number and word != "pair" and r.random() < 0.5):
        head.first("nummod", Node(NUMBERS[min(number, 10) - 2], "CD"))
    first = Node(word, "NN").left("det", Node("a", "DT"))
    if r.random() < 0.1:
        first.before.append(("amod", Node(r.choice(("small", "neat", "matching", "large")), "JJ")))
    return first.right("prep", prep("of", head))


def the(word, tag="NN", modifiers=()):
    node = Node(word, tag).left("det", Node("the", "DT"))
    for modifier in modifiers:
        node.left(*modifier)
    return node


def room(r, definite=False):
    word = r.choice(ROOM_COMPOUNDS) if r.random() < 0.5 else r.choice(ROOMS)
    *before, last = word.split()
    node = Node(last, "NN")
    for part in before:
        node.left("compound", Node(part, "NN"))
    if r.random() < 0.5:
        arc, modifier = adjective(r.choice(MOODS + ["large", "small", "narrow", "minimalist", "modern"]))
        node.first(arc, modifier)
    first = node.words()[0][0].word
    return node.first("det", Node("the" if definite else r.choice((det_for(first),) * 5 + ("this", "the")), "DT"))


SIDES = ("left", "right", "far", "back", "opposite", "front", "near", "north", "south", "east", "west", "long", "rear")


def wall(r):
    if r.random() < 0.12:
        return Node("wall", "NN").left("nummod", Node("one", "CD"))
    if r.random() < 0.12:
        walls = Node("walls", "NNS")
        if r.random() < 0.4:
            walls.left("amod", Node(r.choice(("side", "opposite", "long", "outer")), "JJ"))
        return walls.first(
            *r.choice((("det", Node("both", "DT")), ("det", Node("the", "DT")), ("nummod", Node("two", "CD")), ("det", Node("all", "DT"))))
        )
    if r.random() < 0.4:
        return the("wall")
    if r.random() < 0.12:
        return the("wall").right("prep", prep("opposite", the(r.choice(("door", "window", "bed")))))
    return the("wall", modifiers=[("amod", Node(r.choice(SIDES), "JJ"))])


def of_room(r, node):
    if r.random() < 0.4:
        node.right("prep", prep("of", the(r.choice(("room", "room", "space", "bedroom", "kitchen")))))
    return node


def opening(r):
    return the(
        r.choice(("window", "door", "window", "doorway", "entrance", "fireplace")),
        modifiers=[("amod", Node("large", "JJ"))] if r.random() < 0.15 else [],
    )


def room_place(r):
    """A place in the room: (arc, node) to hang on a verb or a noun."""
    chosen = r.random()
    if chosen < 0.3:
        return "prep", prep(r.choice(("against", "against", "along", "on", "at", "by", "near")), wall(r))
    if chosen < 0.55:
        modifiers = [("amod", Node(r.choice(("left", "right", "far", "back", "opposite", "other")), "JJ"))] if r.random() < 0.4 else []
        corner = the("corner", modifiers=modifiers) if r.random() < 0.8 else Node("corner", "NN").left("nummod", Node("one", "CD"))
        return "prep", prep(r.choice(("in", "in", "in", "into")) if r.random() < 0.3 else "in", of_room(r, corner))
    if chosen < 0.7:
        return "prep", prep(r.choice(("in", "at")), of_room(r, the(r.choice(("center", "middle")))))
    if chosen < 0.9:
        return beside(r, opening(r), openings=True)
    if chosen < 0.95:
        side = the("side", modifiers=[("amod", Node(r.choice(("left", "right", "other", "far")), "JJ"))])
        return "prep", prep("on", of_room(r, side))
    return "advmod", Node(r.choice(("nearby", "there", "here", "opposite", "alone")), "RB")


def beside(r, other, openings=False):
    """Next to, left of, in front of … something: (arc, node)."""
    chosen = r.random()
    adverb = Node(r.choice(("directly", "right", "just", "immediately", "diagonally")), "RB") if r.random() < 0.12 else None
    if chosen < 0.25:
        node = Node("next", "RB").right("prep", prep("to", other))
        arc = "advmod"
    elif chosen < 0.5:
        node, arc = prep(r.choice(("beside", "near", "by", "behind", "opposite", "beside", "beneath", "under", "alongside")), other), "prep"
    elif chosen < 0.62:
        node, arc = prep("in", Node("front", "NN").right("prep", prep("of", other))), "prep"
    elif chosen < 0.72:
        node, arc = prep("to", the(r.choice(("left", "right"))).right("prep", prep("of", other))), "prep"
    elif chosen < 0.77:
        side = the("side", modifiers=[("amod", Node(r.choice(("left", "right")), "JJ"))])
        node, arc = prep("on", side.right("prep", prep("of", other))), "prep"
    elif chosen < 0.83:
        node, arc = prep("across from", other), "prep"
    elif chosen < 0.88:
        node, arc = Node(r.choice(("close", "adjacent")), "JJ").right("prep", prep("to", other)), "advmod"
    elif chosen < 0.92:
        node, arc = Node("facing", "VBG").right("dobj", other), "advcl"
    elif chosen < 0.95 and not openings:
        node, arc = prep("at", the(r.choice(("foot", "head", "end", "edge"))).right("prep", prep("of", other))), "prep"
    elif chosen < 0.97:
        node, arc = Node("away", "RB").right("prep", prep("from", other)), "advmod"
    else:
        node, arc = prep("within", Node("reach", "NN").right("prep", prep("of", other))), "prep"
    if adverb is not None and arc != "advcl":
        node.first("advmod", adverb)
    return arc, node


def upon(r, host):
    """On top of something: (arc, node)."""
    chosen = r.random()
    if chosen < 0.6:
        return "prep", prep("on", host)
    if chosen < 0.75:
        return "prep", prep(r.choice(("atop", "upon")), host)
    if chosen < 0.87:
        return "prep", prep("on", Node("top", "NN").right("prep", prep("of", host)))
    if chosen < 0.92:
        return "prep", prep(r.choice(("across", "over")), host)
    side = the(
        r.choice(("side", "edge", "end", "half", "corner")),
        modifiers=[("amod", Node(r.choice(("left", "right", "far", "other", "front")), "JJ"))],
    )
    return "prep", prep(r.choice(("on", "at")), side.right("prep", prep("of", host)))


def around(r, other):
    return "prep", prep(r.choice(("around", "around", "along", "round")), other)


def above(r, other):
    return "prep", prep(r.choice(("above", "above", "over")), other)
