"""Verbs, mentions and places of things, for room_clauses.py and room_decorate.py."""

from room_phrases import above, around, beside, noun, of_room, room, room_place, the, upon, wall
from tree_text import Node, prep

POSTURE = {
    "floor": ("stand", "sit", "rest", "be", "stand", "go", "stay"),
    "small": ("sit", "rest", "stand", "lie", "be", "sit"),
    "wall": ("hang", "hang", "be"),
    "ceiling": ("hang", "hang", "dangle"),
    "rug": ("lie", "lie", "be", "stretch", "sit"),
}


PLACED = {
    "floor": ("placed", "positioned", "located", "situated", "set", "arranged", "put", "pushed", "tucked", "nestled", "found"),
    "small": ("placed", "set", "arranged", "positioned", "displayed", "perched", "scattered"),
    "wall": ("mounted", "hung", "placed", "fixed"),
    "ceiling": ("hung", "suspended", "mounted"),
    "rug": ("laid", "spread", "placed", "rolled"),
}


ADVERBS = ("neatly", "gracefully", "prominently", "proudly", "quietly", "comfortably", "snugly", "elegantly", "also", "always")


BE = {True: ("are", "VBP"), False: ("is", "VBZ")}


def third(word):
    irregular = {"be": "is", "have": "has", "go": "goes"}
    return irregular.get(word) or (
        word + "es" if word.endswith(("s", "sh", "ch", "x")) else word[:-1] + "ies" if word.endswith("ry") else word + "s"
    )


def gerund(word):
    return {"lie": "lying", "be": "being", "sit": "sitting", "put": "putting"}.get(word) or (
        word[:-1] if word.endswith("e") else word
    ) + "ing"


def end(root, sign="."):
    return root.right("punct", Node(sign, "PUNCT"))


def mention(r, item, definite=None):
    known = item.said if definite is None else definite
    item.said = True
    return noun(r, item.thing, item.number, definite=known or r.random() < 0.06)


def place(r, kind, other):
    """(arc, node) of a place by its kind; `other` is a phrase or None."""
    if kind == "room" or (other is None and kind not in {"wall", "ceiling"}):
        return room_place(r)
    if kind == "beside":
        return beside(r, other)
    if kind == "on":
        return upon(r, other)
    if kind == "around":
        return around(r, other)
    if kind == "above":
        return above(r, other)
    if kind == "under":
        return "prep", prep(r.choice(("under", "beneath", "underneath", "below")), other)
    if kind == "wall":
        return "prep", prep("on", wall(r))
    if kind == "ceiling":
        return "prep", prep("from", the("ceiling"))
    side = Node(r.choice(("side", "side", "end")), "NN").left("det", Node(r.choice(("either", "each")), "DT"))
    if r.random() < 0.25:
        side = Node("sides", "NNS").left("det", Node("both", "DT"))
    return "prep", prep(r.choice(("on", "on", "at")), side.right("prep", prep("of", other)))


def attach(host, places):
    for arc, node in places:
        if arc == "advcl" and host.tag.startswith("NN"):
            arc = "acl"
        host.right(arc, node)
    return host


def head_verb(r, thing, many, modal=True):
    """(root, label of the subject): "stands", "is placed", "should be placed", "is standing"."""
    kind = thing.place
    helper = Node(r.choice(("should", "can", "will", "must", "could", "would")), "MD") if modal and r.random() < 0.15 else None
    chosen = r.random()
    if chosen < 0.45:
        word = r.choice(POSTURE[kind])
        if helper is not None:
            return Node(word, "VB").left("aux", helper), "nsubj"
        if word == "be":
            return Node(*BE[many]), "nsubj"
        root = Node(word if many else third(word), "VBP" if many else "VBZ")
    elif chosen < 0.55:
        word = r.choice([word for word in POSTURE[kind] if word != "be"])
        return Node(gerund(word), "VBG").left("aux", Node(*BE[many])), "nsubj"
    else:
        root = Node(r.choice(PLACED[kind]), "VBN")
        if helper is not None:
            root.left("aux", helper).left("auxpass", Node("be", "VB"))
        else:
            root.left("auxpass", Node(*BE[many]))
        if r.random() < 0.1:
            root.left("advmod", Node(r.choice(ADVERBS), "RB"))
        return root, "nsubjpass"
    if r.random() < 0.08:
        root.right("advmod", Node(r.choice(ADVERBS), "RB"))
    elif r.random() < 0.04:
        root.right("acomp", Node(r.choice(("open", "empty", "ready", "upright", "alone", "folded")), "JJ"))
    return root, "nsubj"


# Verbs by what they say: (host is subject?, verbs, kinds of facts)
HOLD = ("hold", "support", "display", "carry", "have", "feature", "host", "bear", "showcase")


REACH = {
    "room": ("occupy", "fill", "command", "anchor", "dominate"),
    "beside": ("face", "flank", "overlook", "adjoin", "touch"),
    "around": ("surround", "circle", "encircle", "ring"),
    "sides": ("flank", "frame", "bracket"),
    "above": ("illuminate", "light", "crown", "overlook"),
    "wall": ("adorn", "decorate", "cover", "line", "grace"),
    "under": ("anchor", "underlie", "ground"),
    "ceiling": ("brighten", "light"),
    "on": ("top", "adorn", "cover"),
}


def finite(r, word, many):
    chosen = r.random()
    if chosen < 0.08:
        return Node(word, "VB").left("aux", Node(r.choice(("should", "can", "will", "could")), "MD"))
    if chosen < 0.14:
        return Node(gerund(word), "VBG").left("aux", Node(*BE[many]))
    return Node(word if many else third(word), "VBP" if many else "VBZ")


def reach_object(r, fact, other):
    if other is not None:
        return other
    if fact.kind == "ceiling":
        return room(r, True)
    if fact.kind == "wall":
        return wall(r)
    return of_room(r, the(r.choice(("corner", "center", "middle", "wall")))) if r.random() < 0.6 else wall(r)
