"""Clauses about facts as trees, for room_styles.py."""

from room_basics import BE, HOLD, PLACED, POSTURE, REACH, attach, finite, gerund, head_verb, mention, place, reach_object, third
from room_decorate import decorate
from room_phrases import beside, noun, opening, room_place, upon, wall
from tree_text import Node, join, prep


def place_for(r, scene, fact, other=None):
    """Places for a fact; now and then two."""
    if other is None and fact.other is not None:
        other = mention(r, fact.other)
        if r.random() < 0.25:
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
    pronoun = None
    if fact.other is not None and fact.other.said and r.random() < 0.25:
        pronoun = Node("it" if fact.other.number == 1 else "them", "PRP")
    places = place_for(r, scene, fact, pronoun)
    (arc, node), rest = places[0], places[1:]
    many = fact.subject.number != 1
    subject = mention(r, fact.subject)
    chosen = r.random()
    pause = Node(",", "PUNCT") if r.random() < 0.4 else None
    if chosen < 0.25:
        root, label = head_verb(r, fact.subject.thing, many, modal=False)
        root.first(label, subject)
    elif chosen < 0.33:
        words = [word for word in POSTURE[fact.subject.thing.place] if word != "be"]
        standing = r.random() < 0.5
        root = Node(gerund(r.choice(words)), "VBG") if standing else Node(r.choice(PLACED[fact.subject.thing.place]), "VBN")
        root.left("aux" if standing else "auxpass", Node(*BE[many])).right("nsubj" if standing else "nsubjpass", subject)
        pause = None
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
    elif not many and r.random() < 0.15:
        root = Node("'s", "VBZ").left("expl", Node("there", "EX"))
    else:
        root = Node(*BE[many]).left("expl", Node("there", "EX"))
    if r.random() < 0.06:
        root.right("advmod", Node("also", "RB"))
    return root.right("attr", subject)


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
    if r.random() < 0.4:
        subject = decorate(r, scene, fact.subject, subject, most=1)
    if other is not None and r.random() < 0.3:
        other = decorate(r, scene, fact.other, other, most=1)
    if many and fact.kind == "room" and r.random() < 0.4:
        return finite(r, r.choice(("line", "cover", "fill")), many).first("nsubj", subject).right("dobj", wall(r))
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


def drop_first(phrase):
    """Without its article."""
    if phrase.before and phrase.before[0][0] == "det":
        phrase.before.pop(0)
    return phrase


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
    if chosen < 0.42:
        return bare.right("punct", Node(r.choice((",", ":")), "PUNCT")).right("appos", drop_first(wall(r)))
    places = place_for(r, scene, fact, noun(r, fact.other.thing, fact.other.number, definite=True) if fact.other else None)
    if r.random() < 0.4:
        for _, node in places:
            for _, below in node.after:
                if below.before and below.before[0][0] == "det":
                    below.before.pop(0)
    return attach(bare, places)
