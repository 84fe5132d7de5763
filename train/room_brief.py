"""Rooms in a line, as people write who are in a hurry; trees like those of room_styles.py.

"Guest room, 4 x 3 m: queen bed with two nightstands, dresser opposite the bed, bench at its foot and a lamp in the corner."
"""

from room_basics import attach, mention, place
from room_decorate import bare, quality
from room_phrases import noun, opening, room, room_place
from room_scene import Scene
from tree_text import Node, join, prep

UNITS = ("m", "meters", "ft", "feet", "cm", "inches", "foot", "meter")


def number(r):
    whole = str(r.choice((r.randint(2, 12), r.randint(2, 12), r.randint(20, 200))))
    return Node(whole + (f".{r.randint(1, 9)}" if r.random() < 0.2 else ""), "CD")


def size(r):
    """ "4 x 3 m", "12 by 14 feet", "25 m": the unit with its numbers."""
    last = number(r)
    chosen = r.random()
    if chosen < 0.5:
        last.left("quantmod", number(r)).left("punct", Node("x", "SYM"))
    elif chosen < 0.75:
        last.left("quantmod", number(r)).left("quantmod", Node("by", "IN"))
    word = r.choice(UNITS)
    return Node(word, "NNS" if word.endswith("s") or word == "feet" else "NN").left("nummod", last)


def title(r):
    """The room, mostly without a determiner, with its size before or behind it."""
    head = room(r)
    if head.before and head.before[0][0] == "det" and r.random() < 0.7:
        head.before.pop(0)
    chosen = r.random()
    if chosen < 0.15:
        head.first("nmod", size(r))
    elif chosen < 0.4:
        head.right("punct", Node(",", "PUNCT")).right("appos", size(r))
    elif chosen < 0.5:
        head.right("punct", Node("(", "PUNCT")).right("appos", size(r)).right("punct", Node(")", "PUNCT"))
    if r.random() < 0.15:
        people = Node(r.choice(("people", "children", "students", "guests", "twins", "patients")), "NNS")
        if r.random() < 0.7:
            people.left("nummod", Node(r.choice(("two", "three", "six", "12", "20")), "CD"))
        head.right("prep", prep("for", people))
    return head


def drop_article(r, phrase, share):
    if phrase.before and phrase.before[0][0] == "det" and phrase.before[0][1].word in {"a", "an", "the"} and r.random() < share:
        phrase.before.pop(0)
    return phrase


def with_other(r, scene, phrase, articles):
    """ "with a lamp on it", "with two chairs": what a thing brings along."""
    small = next((item for item in scene.items if item.thing.place == "small" and not item.said), None)
    if small is None:
        return
    held = drop_article(r, mention(r, small), articles)
    chosen = r.random()
    if chosen < 0.4:
        word = r.choice(("on it", "on top", "above", "above it", "in front", "beside it", "behind it", "underneath", "next to it"))
        first, *rest = word.split()
        if first == "next":
            held.right("advmod", Node("next", "RB").right("prep", prep("to", Node("it", "PRP"))))
        elif rest:
            held.right("prep", prep(first, Node(rest[0], "PRP" if rest[0] == "it" else "NN")))
        else:
            held.right("advmod", Node(first, "RB"))
    phrase.right("prep", prep("with", held))


def part(r, scene, item, articles):
    """One thing of the list with where it stands."""
    phrase = drop_article(r, mention(r, item), articles)
    if r.random() < 0.08:
        quality(r, phrase, item.number != 1)
    elif r.random() < 0.25:
        with_other(r, scene, phrase, articles)
    chosen = r.random()
    others = [other for other in scene.items if other.said and other is not item]
    if chosen < 0.25 and others:
        other = r.choice(others)
        target = drop_article(r, noun(r, other.thing, other.number, definite=True), articles) if r.random() < 0.6 else Node("it", "PRP")
        attach(phrase, [place(r, r.choice(("beside", "beside", "above", "around", "sides")), target)])
    elif chosen < 0.5:
        attach(phrase, [room_place(r)])
    elif chosen < 0.58:
        phrase.right("acl", Node("facing", "VBG").right("dobj", opening(r)))
    elif chosen < 0.64:
        phrase.right("advmod", Node(r.choice(("left", "right", "opposite", "nearby", "behind")), "RB"))
    elif chosen < 0.7:
        side = Node(r.choice(("left", "right")), "NN").left("det", Node("the", "DT"))
        phrase.right("prep", prep(r.choice(("on", "to")), side))
    return phrase


def chain(r, parts):
    """A list with commas, or semicolons, and perhaps "and" before the last."""
    chosen = r.random()
    if chosen < 0.55:
        return join(parts, oxford=r.random() < 0.4)
    if chosen < 0.9 or len(parts) == 1:
        return join(parts, comma_only=True)
    return join(parts, conjunction="plus" if r.random() < 0.3 else "and")


def brief(r):
    """A title and its list in one sentence; now and then a second list."""
    scene = Scene(r)
    articles = r.choice((0.0, 0.2, 0.95, 0.95))
    floor = [item for item in scene.items if item.thing.place != "small"] or scene.items
    parts = [part(r, scene, item, articles) for item in floor[: r.randint(1, 7)]]
    members = chain(r, parts)
    head = title(r)
    chosen = r.random()
    if chosen < 0.45:
        root = head.right("prep", prep("with", members))
    elif chosen < 0.6:
        root = head.right("punct", Node(":", "PUNCT")).right("appos", members)
    elif chosen < 0.85:
        root = head.right("punct", Node(",", "PUNCT")).right("appos", members)
    elif chosen < 0.95:
        root = members
    else:
        root = head.right("punct", Node(":", "PUNCT")).right(
            "appos", bare(r.choice(("two doors", "three drawers", "a mirror"))).right("conj", members)
        )
        root.after[-1][1].after.insert(0, ("punct", Node(",", "PUNCT")))
    yield root.right("punct", Node(r.choice((".", ".", ".", ";", "!")), "PUNCT"))
