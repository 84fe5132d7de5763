"""Manners of room_styles.py with long sentences: asides, groups, two predicates."""

from room_asides import company, each_with, one_of_which, with_clause, with_effect
from room_basics import PLACED, POSTURE, end, finite, gerund, mention, place
from room_clauses import clause, inverted, verb
from room_phrases import room
from room_scene import Scene
from tree_text import Node, prep


def annotator(r):
    """Long sentences with asides: ", with a mirror hanging above it", ", each with a lamp", ", adding warmth to the space\""""
    scene = Scene(r)
    while (fact := scene.take()) is not None:
        chosen = r.random()
        root = clause(r, scene, fact, modal=False) if chosen < 0.5 else verb(r, scene, fact) if chosen < 0.75 else inverted(r, scene, fact)
        aside(r, scene, fact, root)
        if r.random() < 0.2:
            with_effect(r, root)
        yield end(root)


def aside(r, scene, fact, root):
    more = scene.take(as_other=fact.subject) or (scene.take() if r.random() < 0.4 else None)
    if more is None:
        return
    other = more.other
    if other is fact.subject and r.random() < 0.7:
        pronoun = Node("it" if other.number == 1 else "them", "PRP")
    else:
        pronoun = mention(r, other) if other is not None else None
    kind = more.subject.thing.place
    verbs = [(gerund(word), "VBG") for word in POSTURE[kind] if word != "be"] + [(word, "VBN") for word in PLACED[kind]]
    with_clause(r, root, mention(r, more.subject), [place(r, more.kind, pronoun)], verbs)


def groups(r):
    """ "The bed is flanked by two nightstands, each with a lamp", "a sofa paired with a stool\""""
    scene = Scene(r)
    for item in list(scene.items):
        small = next((other for other in scene.items if other.thing.place == "small" and not other.said), None)
        if item.said or small is None or item.thing.place == "small":
            continue
        phrase = mention(r, item)
        held = mention(r, small)
        if item.number == 1:
            company(r, phrase, held)
        elif r.random() < 0.75:
            each_with(r, phrase, held)
        else:
            one_of_which(r, phrase, held)
        fact = scene.take(item=item)
        chosen = r.random()
        if fact is not None and chosen < 0.5:
            arc, node = place(r, fact.kind, mention(r, fact.other) if fact.other is not None else None)
            root = Node("is" if item.number == 1 else "are", "VBZ" if item.number == 1 else "VBP")
            if r.random() < 0.5:
                root.left("expl", Node("there", "EX"))
            root = root.first(arc, node).right("attr", phrase)
        elif chosen < 0.75:
            root = Node(r.choice(("has", "features", "includes", "contains")), "VBZ").left("nsubj", room(r)).right("dobj", phrase)
        else:
            root = room(r).right("prep", prep("with", phrase))
        yield end(root)


def predicates(r):
    """ "A desk stands in the corner and faces the window.\""""
    scene = Scene(r)
    for item in list(scene.items):
        facts = [fact for fact in scene.facts if fact.subject is item and not fact.used]
        if not facts:
            continue
        facts[0].used = True
        root = clause(r, scene, facts[0], modal=False)
        subject_many = item.number != 1
        following = None
        chosen = r.random()
        held = scene.take(as_other=item, kinds={"on"})
        if held is not None and chosen < 0.6:
            following = finite(r, r.choice(("hold", "support", "display", "carry", "have")), subject_many).right(
                "dobj", mention(r, held.subject)
            )
        elif chosen < 0.8:
            other = r.choice(scene.items)
            if other is not item:
                following = finite(r, r.choice(("face", "overlook", "touch", "adjoin", "flank")), subject_many).right(
                    "dobj", mention(r, other)
                )
        if following is not None:
            if r.random() < 0.15:
                root.right("punct", Node(",", "PUNCT"))
            root.right("cc", Node("and", "CC")).right("conj", following)
        yield end(root)
