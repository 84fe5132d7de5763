"""Clauses about facts as trees, for room_styles.py."""

from room_phrases import NUMBERS, above, around, beside, noun, of_room, opening, room, room_place, the, upon, wall
from tree_text import Node, join, prep

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


def participle(word):
    return {"hold": "held", "light": "lit", "set": "set", "overlook": "overlooked"}.get(word) or word + (
        "d" if word.endswith("e") else "ed"
    )


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


def place_for(r, scene, fact, other=None):
    """Places for a fact; now and then two."""
    if other is None and fact.other is not None:
        other = mention(r, fact.other)
        if fact.kind != "on" and r.random() < 0.15:
            other = decorate(r, scene, fact.other, other, most=1)
    places = [place(r, fact.kind, other)]
    if fact.kind == "room" and places[0][0] == "prep" and r.random() < 0.2:
        places.append(beside(r, opening(r), openings=True))
    more = scene.take(item=fact.subject) if r.random() < 0.25 else None
    if more is not None and more.kind != "room":
        places.append(place(r, more.kind, mention(r, more.other) if more.other else None))
    elif more is not None:
        places.append(room_place(r))
    return places


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


def subject_of(r, scene, fact):
    subject = mention(r, fact.subject)
    if r.random() < 0.4:
        subject = decorate(r, scene, fact.subject, subject, most=1, forbidden=fact)
    return subject


def clause(r, scene, fact, modal=True):
    subject = subject_of(r, scene, fact)
    if r.random() < 0.12:  # two subjects
        other = next((item for item in scene.items if not item.said and item.thing.place == fact.subject.thing.place), None)
        if other is not None:
            subject = join([subject, mention(r, other)])
            root, label = head_verb(r, fact.subject.thing, True, modal)
            return attach(root.first(label, subject), place_for(r, scene, fact))
    root, label = head_verb(r, fact.subject.thing, fact.subject.number != 1, modal)
    return attach(root.first(label, subject), place_for(r, scene, fact))


def inverted(r, scene, fact):
    """ "On the table a bowl sits", "On the table stands a bowl", "Next to it is a jar\""""
    places = place_for(r, scene, fact)
    (arc, node), rest = places[0], places[1:]
    many = fact.subject.number != 1
    subject = mention(r, fact.subject)
    chosen = r.random()
    pause = Node(",", "PUNCT") if r.random() < 0.4 else None
    if chosen < 0.25:
        root, label = head_verb(r, fact.subject.thing, many, modal=False)
        root.first(label, subject)
    elif chosen < 0.65:
        word = r.choice(POSTURE[fact.subject.thing.place])
        root = Node(*BE[many]) if word == "be" else Node(word if many else third(word), "VBP" if many else "VBZ")
        root.right("attr" if word == "be" else "nsubj", decorate(r, scene, fact.subject, subject, most=1) if r.random() < 0.3 else subject)
        pause = None
    else:
        root = (
            Node(*BE[many])
            .left("expl", Node("there", "EX"))
            .right("attr", decorate(r, scene, fact.subject, subject, most=1) if r.random() < 0.3 else subject)
        )
    if pause is not None:
        root.first("punct", pause)
    root.first(arc, node)
    return attach(root, rest if chosen < 0.25 else [])


def there_is(r, scene, fact, modal=False):
    many = fact.subject.number != 1
    subject = attach(mention(r, fact.subject), place_for(r, scene, fact))
    if modal or r.random() < 0.1:
        root = Node("be", "VB").left("expl", Node("there", "EX")).left("aux", Node(r.choice(("should", "must", "can")), "MD"))
    else:
        root = Node(*BE[many]).left("expl", Node("there", "EX"))
    if r.random() < 0.06:
        root.right("advmod", Node("also", "RB"))
    return root.right("attr", subject)


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


def verb(r, scene, fact):
    """A verb that is itself the relation: holds, occupies, lines, illuminates, is flanked by."""
    other = mention(r, fact.other) if fact.other is not None else None
    many = fact.subject.number != 1
    if fact.kind == "on" and r.random() < 0.75 and fact.other is not None:
        host_many = fact.other.number != 1
        held = [mention(r, fact.subject)]
        while r.random() < 0.5 and (more := scene.take(as_other=fact.other, kinds={"on"})) is not None:
            held.append(mention(r, more.subject))
        if r.random() < 0.2:
            held[-1] = decorate(r, scene, fact.subject, held[-1], most=1) if len(held) == 1 else held[-1]
        if r.random() < 0.2:
            other = decorate(r, scene, fact.other, other, most=1)
        things = join(held, oxford=r.random() < 0.5)
        if r.random() < 0.35:
            root = Node(r.choice(("topped", "decorated", "adorned", "set", "covered", "equipped")), "VBN").left("nsubjpass", other)
            return root.left("auxpass", Node(*BE[host_many])).right("prep", prep("with", things))
        return finite(r, r.choice(HOLD), host_many).first("nsubj", other).right("dobj", things)
    subject = mention(r, fact.subject)
    if fact.kind in {"sides", "around"} and other is not None and r.random() < 0.5:
        root = Node(r.choice(("flanked", "framed") if fact.kind == "sides" else ("surrounded", "encircled")), "VBN").left(
            "nsubjpass", other
        )
        return root.left("auxpass", Node(*BE[fact.other.number != 1])).right("agent", prep("by", subject))
    if r.random() < 0.25:
        subject = decorate(r, scene, fact.subject, subject, most=1)
    if other is not None and r.random() < 0.25:
        other = decorate(r, scene, fact.other, other, most=1)
    root = finite(r, r.choice(REACH[fact.kind]), many).first("nsubj", subject)
    return root.right("dobj", reach_object(r, fact, other))


def listing(r, scene, item):
    """ "The desk holds a lamp and a book, and the shelf two jars": all that stands on an item."""
    facts = [fact for fact in scene.facts if fact.other is item and fact.kind == "on"]
    if not facts:
        return None
    for fact in facts:
        fact.used = True
    host = mention(r, item)
    things = [
        decorate(r, scene, fact.subject, mention(r, fact.subject), most=1) if r.random() < 0.2 else mention(r, fact.subject)
        for fact in facts
    ]
    chosen = r.random()
    many = item.number != 1
    if chosen < 0.4:
        root = finite(r, r.choice(HOLD), many).first("nsubj", host).right("dobj", join(things, oxford=r.random() < 0.5))
        others = [other for other in scene.items if other is not item and other.thing.place == "floor"]
        small = [other for other in scene.items if not other.said and other.thing.place == "small"]
        if others and small and r.random() < 0.4:
            rest = mention(r, r.choice(others)).right("dobj", mention(r, small[0]))
            root.right("punct", Node(",", "PUNCT"))
            if r.random() < 0.8:
                root.right("cc", Node("and", "CC"))
            root.right("conj", rest)
        return root
    root = join(things, oxford=r.random() < 0.5)
    if chosen < 0.6:
        many = len(things) > 1 or facts[0].subject.number != 1
        stand, label = head_verb(r, facts[0].subject.thing, many)
        return attach(stand.first(label, root), [upon(r, host)])
    if chosen < 0.8:
        arc, node = upon(r, host)
        is_ = Node(*BE[len(things) > 1 or facts[0].subject.number != 1])
        if r.random() < 0.5:
            is_.left("expl", Node("there", "EX"))
        return is_.first(arc, node).right("attr", root)
    return root.right(*upon(r, host)) if len(things) == 1 else things[-1].right(*upon(r, host)) and root


def gapped(r, scene, fact):
    """What is left of a clause without its verb: "the wardrobe against the right wall\""""
    return attach(mention(r, fact.subject), place_for(r, scene, fact))


def telegraphic_item(r, scene, fact):
    bare = noun(r, fact.subject.thing, fact.subject.number, plain=r.random() < 0.6)
    fact.subject.said = True
    if r.random() < 0.6 and bare.before and bare.before[0][0] == "det":
        bare.before.pop(0)
    chosen = r.random()
    if chosen < 0.2:
        return bare.right("advmod", Node(r.choice(("left", "right", "center", "back", "front")), "RB"))
    if chosen < 0.35:
        return bare
    places = place_for(r, scene, fact, noun(r, fact.other.thing, fact.other.number, definite=True) if fact.other else None)
    if r.random() < 0.4:
        for _, node in places:
            for _, below in node.after:
                if below.before and below.before[0][0] == "det":
                    below.before.pop(0)
    return attach(bare, places)


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


def relative(r, host, clause_):
    """Hangs a relative clause on a noun, after a comma now and then."""
    if r.random() < 0.25:
        host.right("punct", Node(",", "PUNCT"))
    return host.right("relcl", clause_)


def decorate(r, scene, item, phrase, most=2, forbidden=None):
    """Hangs facts on a noun phrase: "with a lamp on it", "that faces the window", "placed in the corner\""""
    many = item.number != 1
    host = phrase
    if r.random() < 0.12:
        quality(r, host, many)
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
        chosen = r.random()
        if chosen < 0.4:
            on = prep("on", Node("them" if many else "it", "PRP") if r.random() < 0.6 else Node("top", "NN"))
            host.right("prep", prep("with", held.right("prep", on)))
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
    elif chosen < 0.87:
        root, label = head_verb(r, fact.subject.thing, many, modal=False)
        relative(r, host, attach(root.first(label, Node(r.choice(("that", "which")), "WDT")), places))
    else:
        word = r.choice(REACH[fact.kind])
        if fact.kind in {"around", "sides", "above", "wall"} and fact.other is None:
            attach(host, places)
            return
        host.right("acl", Node(gerund(word), "VBG").right("dobj", reach_object(r, fact, mention(r, fact.other) if fact.other else None)))
