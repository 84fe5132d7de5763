"""What hangs on a noun phrase: parts, purposes, relative clauses, and facts about the thing; for room_clauses.py."""

from room_basics import BE, HOLD, PLACED, POSTURE, REACH, attach, finite, gerund, head_verb, mention, place, reach_object, third
from room_phrases import NUMBERS, the
from tree_text import Node, join, prep

PARTS = (
    "drawers",
    "wheels",
    "shelves",
    "armrests",
    "doors",
    "legs",
    "cushions",
    "handles",
    "casters",
    "a shade",
    "a marble top",
    "a glass top",
    "a headboard",
    "a mirror",
    "a footrest",
    "four legs",
    "three drawers",
    "two doors",
    "a drawer",
    "curtains",
    "a frame",
    "a backrest",
    "storage",
)


MATERIALS = ("oak", "wood", "glass", "steel", "marble", "leather", "velvet", "bamboo", "rattan", "concrete")


PURPOSES = ("reading", "storage", "studying", "guests", "work", "homework", "drawing", "toys", "relaxation", "entertainment")


def bare(words):
    """ "a glass top", "drawers" as a phrase."""
    *before, last = words.split()
    node = Node(last, "NNS" if last.endswith("s") and last != "glass" else "NN")
    for word in before:
        arc, tag = ("det", "DT") if word == "a" else ("nummod", "CD") if word in NUMBERS else ("compound", "NN")
        node.left(arc, Node(word, tag))
    return node


def quality(r, host, many):
    """What is no other thing: parts, material, purpose, size, seats."""
    chosen = r.random()
    number = Node(r.choice(NUMBERS), "CD")
    if chosen < 0.3:
        host.right("prep", prep("with", bare(r.choice(PARTS))))
    elif chosen < 0.4:
        host.right("acl", Node("made", "VBN").right("prep", prep("of", Node(r.choice(MATERIALS), "NN"))))
    elif chosen < 0.55:
        word = r.choice(PURPOSES)
        host.right(
            "prep",
            prep("for", Node(word, "NNS" if word.endswith("s") else "NN"))
            if not word.endswith("ing")
            else prep("for").right("pcomp", Node(word, "VBG")),
        )
    elif chosen < 0.7:
        host.right(
            "prep",
            prep(
                "for",
                Node(r.choice(("people", "guests", "children", "students")), "NNS").left("nummod", number) if r.random() < 0.7 else number,
            ),
        )
    elif chosen < 0.85:
        verb_ = Node(r.choice(("seat", "fit", "sleep")) if many else r.choice(("seats", "fits", "sleeps")), "VBP" if many else "VBZ")
        host.right("relcl", verb_.left("nsubj", Node(r.choice(("that", "which")), "WDT")).right("dobj", number))
    elif chosen < 0.92:
        host.right("acl", Node("seating", "VBG").right("dobj", number))
    else:
        unit = Node(r.choice(("meters", "cm", "feet", "inches")), "NNS").left("nummod", Node(str(r.randint(2, 90)), "CD"))
        wide = Node(r.choice(("wide", "long", "tall", "high", "deep")), "JJ").left("npadvmod", unit)
        host.right("relcl", Node(*BE[many]).left("nsubj", Node("that", "WDT")).right("acomp", wide))


THINGS_SEEN = ("window", "garden", "door", "wall", "room", "fireplace", "entrance", "street", "cabin", "stove", "sea", "hallway")


ACTIONS = (
    "face",
    "overlook",
    "heat",
    "light",
    "fill",
    "divide",
    "hide",
    "block",
    "touch",
    "cover",
    "adjoin",
    "reach",
    "shade",
    "warm",
    "frame",
)


def aside_clause(r, host, many):
    """What says more of a thing without another thing: "on the left", "that overlooks the garden", "which is below the window\""""
    chosen = r.random()
    if chosen < 0.35:
        host.right("prep", prep(r.choice(("on", "on", "to", "at")), the(r.choice(("left", "right", "left", "right", "back", "front")))))
    elif chosen < 0.65:
        seen = the(r.choice(THINGS_SEEN))
        relative(r, host, finite(r, r.choice(ACTIONS), many).first("nsubj", Node(r.choice(("that", "which")), "WDT")).right("dobj", seen))
    elif chosen < 0.8:
        where = prep(r.choice(("below", "near", "beside", "by", "opposite", "under", "behind")), the(r.choice(THINGS_SEEN)))
        relative(r, host, Node(*BE[many]).left("nsubj", Node(r.choice(("that", "which", "which")), "WDT")).right("prep", where))
    elif chosen < 0.9 and many:
        word = r.choice(("side", "back", "face", "end"))
        by = prep("by" if word == "side" else "to", Node(word, "NN"))
        host.right("npadvmod", Node(word, "NN").right("prep", by))
    else:
        host.right("acl", Node(gerund(r.choice(ACTIONS)), "VBG").right("dobj", the(r.choice(THINGS_SEEN))))


def relative(r, host, clause_):
    """Hangs a relative clause on a noun, after a comma now and then."""
    if clause_.words()[0][0].word == "which" and r.random() < 0.5:
        host.right("punct", Node(",", "PUNCT"))
    return host.right("relcl", clause_)


def decorate(r, scene, item, phrase, most=2, forbidden=None):
    """Hangs facts on a noun phrase: "with a lamp on it", "that faces the window", "placed in the corner\""""
    many = item.number != 1
    host = phrase
    if r.random() < 0.14:
        quality(r, host, many)
        most -= 1
    elif r.random() < 0.14:
        aside_clause(r, host, many)
        most -= 1
    for _ in range(most):
        if r.random() < 0.35:
            break
        fact = scene.take(as_other=item, kinds={"on"}) if r.random() < 0.4 else scene.take(item=item)
        if fact is None:
            continue
        if fact is forbidden:
            fact.used = False
            break
        if fact.subject is item:
            own_places(r, scene, fact, host, many)
            break
        held = mention(r, fact.subject)
        more = scene.take(as_other=item, kinds={"on"}) if r.random() < 0.3 else None
        last = held
        if more is not None:
            last = mention(r, more.subject)
            held = join([held, last])
        chosen = r.random()
        if chosen < 0.4:
            on = prep("on", Node("them" if many else "it", "PRP") if r.random() < 0.6 else Node("top", "NN"))
            last.right("prep", on)
            host.right("prep", prep("with", held))
        elif chosen < 0.65:
            host.right("acl", Node(r.choice(("holding", "supporting", "displaying", "carrying", "featuring")), "VBG").right("dobj", held))
        elif chosen < 0.8:
            host.right("acl", Node(r.choice(("topped", "decorated", "adorned", "covered")), "VBN").right("prep", prep("with", held)))
        else:
            relative(r, host, finite(r, r.choice(HOLD), many).first("nsubj", Node(r.choice(("that", "which")), "WDT")).right("dobj", held))
    return phrase


def own_places(r, scene, fact, host, many):
    places = [place(r, fact.kind, mention(r, fact.other) if fact.other else None)]
    chosen = r.random()
    if chosen < 0.35:
        attach(host, places)
    elif chosen < 0.6:
        host.right("acl", attach(Node(r.choice(PLACED[fact.subject.thing.place]), "VBN"), places))
    elif chosen < 0.75:
        word = r.choice([word for word in POSTURE[fact.subject.thing.place] if word != "be"])
        host.right("acl", attach(Node(gerund(word), "VBG"), places))
    elif chosen < 0.8 and fact.other is None:
        small = next((other for other in scene.items if not other.said), None)
        if small is not None:
            what = mention(r, small)
            word = r.choice(("hang", "stand", "sit", "lie", "rest"))
            stands = Node(third(word), "VBZ") if small.number == 1 else Node(word, "VBP")
            where = prep(r.choice(("above", "on", "under", "behind", "over", "around", "beside")), Node("which", "WDT"))
            relative(
                r, host.right("punct", Node(",", "PUNCT")) if r.random() < 0.7 else host, stands.left("prep", where).right("nsubj", what)
            )
        else:
            attach(host, places)
    elif chosen < 0.87:
        root, label = head_verb(r, fact.subject.thing, many, modal=False)
        relative(r, host, attach(root.first(label, Node(r.choice(("that", "which")), "WDT")), places))
    else:
        word = r.choice(REACH[fact.kind])
        if fact.kind in {"around", "sides", "above", "wall"} and fact.other is None:
            attach(host, places)
            return
        host.right("acl", Node(gerund(word), "VBG").right("dobj", reach_object(r, fact, mention(r, fact.other) if fact.other else None)))
