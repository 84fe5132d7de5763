"""The manners in which room_sentences.py writes: each gets a random source and returns the trees of some sentences."""

from room_asides import company, each_with, one_of_which, with_clause, with_effect
from room_clauses import (
    PLACED,
    POSTURE,
    attach,
    clause,
    decorate,
    end,
    finite,
    gapped,
    gerund,
    inverted,
    listing,
    mention,
    place,
    place_for,
    telegraphic_item,
    there_is,
    verb,
)
from room_phrases import room
from room_scene import Scene
from tree_text import Node, join, prep

STYLES = {}


def style(name, weight=1.0):
    def register(function):
        STYLES[name] = (function, weight)
        return function

    return register


@style("prose", 4)
def prose(r):
    """ "A lamp stands on the desk.", "On the table a bowl sits next to a jar, and a mug rests beside a tray.\""""
    scene = Scene(r)
    while (fact := scene.take()) is not None:
        root = fact_clause(r, scene, fact)
        if r.random() < 0.35 and (second := scene.take()) is not None:
            root = two(r, root, fact_clause(r, scene, second), scene)
        elif r.random() < 0.25:
            with_effect(r, root)
        yield end(root)


def fact_clause(r, scene, fact):
    chosen = r.random()
    if chosen < 0.45:
        return clause(r, scene, fact)
    if chosen < 0.62:
        return inverted(r, scene, fact)
    if chosen < 0.75:
        return there_is(r, scene, fact)
    return verb(r, scene, fact)


def two(r, first, second, scene):
    """Two clauses in one sentence."""
    chosen = r.random()
    if chosen < 0.45:
        if r.random() < 0.7:
            first.right("punct", Node(",", "PUNCT"))
        first.right("cc", Node(r.choice(("and", "and", "and", "but")), "CC"))
        return first.right("conj", second)
    if chosen < 0.6:
        return first.right("punct", Node(r.choice((";", ",")), "PUNCT")).right("conj", second)
    second.first("mark", Node(r.choice(("while", "while", "whereas", "as")), "IN"))
    if chosen < 0.85:
        if r.random() < 0.7:
            first.right("punct", Node(",", "PUNCT"))
        return first.right("advcl", second)
    return first.first("punct", Node(",", "PUNCT")).first("advcl", second)


@style("contents", 3)
def contents(r):
    """ "The bedroom has a bed, two lamps and a desk next to the window.\""""
    scene = Scene(r)
    items = scene.items[: r.randint(1, 5)]
    phrases = [decorate(r, scene, item, mention(r, item)) for item in items]
    members = join(phrases, oxford=r.random() < 0.6, comma_only=r.random() < 0.04 and len(phrases) > 1)
    chosen = r.random()
    if chosen < 0.3:
        where = room(r)
        root = (
            Node(r.choice(("has", "features", "contains", "includes", "offers", "holds", "boasts", "houses")), "VBZ")
            .left("nsubj", where)
            .right("dobj", members)
        )
    elif chosen < 0.6:
        root = room(r)
        chosen = r.random()
        if chosen < 0.6:
            root.right("prep", prep("with", members))
        elif chosen < 0.85:
            root.right("acl", Node(r.choice(("featuring", "containing", "including", "having")), "VBG").right("dobj", members))
        else:
            root.right("acl", Node(r.choice(("furnished", "equipped", "filled")), "VBN").right("prep", prep("with", members)))
        if r.random() < 0.3:
            root = Node(r.choice(("design", "create", "generate", "make", "show", "build")), "VB").right("dobj", root)
    elif chosen < 0.75:
        root = (
            Node("is" if items[0].number == 1 else "are", "VBZ" if items[0].number == 1 else "VBP")
            .left("expl", Node("there", "EX"))
            .right("attr", members)
        )
    elif chosen < 0.85:
        root = (
            Node(r.choice(("furnished", "equipped", "decorated", "filled")), "VBN")
            .left("nsubjpass", room(r, True))
            .left("auxpass", Node("is", "VBZ"))
        )
        root.right("prep", prep("with", members))
    else:
        root = prep("in", room(r, r.random() < 0.5))
        is_ = Node("is" if items[0].number == 1 else "are", "VBZ" if items[0].number == 1 else "VBP").left("prep", root)
        if r.random() < 0.7:
            is_.left("punct", Node(",", "PUNCT"))
        if r.random() < 0.7:
            is_.left("expl", Node("there", "EX"))
        root = is_.right("attr", members)
    yield end(root)
    while (fact := scene.take()) is not None and r.random() < 0.8:
        yield end(fact_clause(r, scene, fact))


@style("commands", 2.5)
def commands(r):
    """ "Place the bed against the left wall and the wardrobe against the right wall.\""""
    scene = Scene(r)
    words = (
        "place",
        "put",
        "position",
        "stand",
        "arrange",
        "set",
        "hang",
        "mount",
        "move",
        "install",
        "push",
        "lay",
        "add",
        "keep",
        "leave",
    )
    while (fact := scene.take()) is not None:
        root = Node(r.choice(words), "VB")
        root.right("dobj", mention(r, fact.subject))
        attach(root, place_for(r, scene, fact))
        last = root
        while r.random() < 0.5 and (more := scene.take()) is not None:
            if r.random() < 0.6:
                following = gapped(r, scene, more)
            else:
                following = attach(Node(r.choice(words), "VB").right("dobj", mention(r, more.subject)), place_for(r, scene, more))
            if r.random() < 0.35:
                last.right("punct", Node(",", "PUNCT"))
            last.right("cc", Node(r.choice(("and", "and", "then")), "CC")) if r.random() < 0.9 or last is not root else last.right(
                "punct", Node(",", "PUNCT")
            )
            last.right("conj", following)
            last = following
        if r.random() < 0.12:
            root.first("intj", Node("please", "UH"))
        yield end(root, "!" if r.random() < 0.03 else ".")


@style("wishes", 1.5)
def wishes(r):
    """ "I would like a desk next to the window.", "Can you put a chair in front of the desk?\""""
    scene = Scene(r)
    while (fact := scene.take()) is not None:
        chosen = r.random()
        stop = "."
        if chosen < 0.5:
            members = decorate(r, scene, fact.subject, mention(r, fact.subject))
            attach(members, place_for(r, scene, fact))
            items = [item for item in scene.items if not item.said][: r.randint(0, 2)]
            members = join([members] + [decorate(r, scene, item, mention(r, item)) for item in items])
            who = r.choice((("i", ""), ("we", ""), ("she", "s"), ("he", "s")))
            word = r.choice(("want", "need", "have", "love", "like"))
            if word == "like" or r.random() < 0.4:
                root = Node(r.choice(("like", "love")), "VB").left("nsubj", Node(who[0], "PRP")).left("aux", Node("would", "MD"))
            elif who[1]:
                root = Node({"have": "has"}.get(word, word + "s"), "VBZ").left("nsubj", Node(who[0], "PRP"))
            else:
                root = Node(word, "VBP").left("nsubj", Node(who[0], "PRP"))
            if r.random() < 0.25:
                inner = Node(r.choice(("have", "see", "put", "get", "add")), "VB").left("aux", Node("to", "TO")).right("dobj", members)
                root.right("xcomp", inner)
            else:
                root.right("dobj", members)
        elif chosen < 0.7:
            root = Node(r.choice(("put", "place", "add", "have", "set")), "VB").left("aux", Node(r.choice(("can", "could", "would")), "MD"))
            root.left("nsubj", Node(r.choice(("you", "you", "we", "i")), "PRP")).right("dobj", mention(r, fact.subject))
            attach(root, place_for(r, scene, fact))
            stop = "?"
        elif chosen < 0.85:
            inner = clause(r, scene, fact)
            if r.random() < 0.5:
                inner.first("mark", Node("that", "IN"))
            root = Node("make", "VB").right("ccomp", Node("sure", "JJ").right("ccomp", inner))
        else:
            root = there_is(r, scene, fact, modal=True)
        yield end(root, stop)


@style("telegraph", 1.5)
def telegraph(r):
    """ "Bedroom, 4x3, bed left, wardrobe in the corner, lamp on desk.\""""
    scene = Scene(r)
    facts = []
    while (fact := scene.take()) is not None:
        facts.append(fact)
    parts = [telegraphic_item(r, scene, fact) for fact in facts[:6]]
    if r.random() < 0.5:
        first = room(r)
        if r.random() < 0.7 and first.before and first.before[0][0] == "det":
            first.before.pop(0)
        parts.insert(0, first)
    if not parts:
        return
    if r.random() < 0.4:
        yield from (end(part, r.choice((";", "."))) for part in parts)
        return
    head = parts[0]
    colon = r.random() < 0.25 and len(parts) > 1
    for i in range(1, len(parts)):
        parts[i - 1].right("punct", Node(":" if colon and i == 1 else ",", "PUNCT"))
        if i == len(parts) - 1 and r.random() < 0.3:
            parts[i - 1].right("cc", Node("and", "CC"))
        parts[i - 1].right("appos" if colon and i == 1 else "conj", parts[i])
    yield end(head, r.choice((".", ".", ";")))


@style("verbs", 2.5)
def verbs(r):
    """Verbs of holding, filling and lining: "Plants line the wall.\""""
    scene = Scene(r)
    while (fact := scene.take()) is not None:
        root = verb(r, scene, fact)
        if r.random() < 0.35 and (second := scene.take()) is not None:
            root = two(r, root, verb(r, scene, second), scene)
        yield end(root)


@style("lists", 1.5)
def lists(r):
    """ "The desk holds a lamp, a mug and a book, and the shelf two jars.\""""
    scene = Scene(r)
    for item in list(scene.items):
        root = listing(r, scene, item)
        if root is not None:
            yield end(root)


@style("nominal", 1.5)
def nominal(r):
    """Phrases with relative clauses and participles: "a desk that faces the window and holds a lamp\""""
    scene = Scene(r)
    for item in list(scene.items):
        if item.said:
            continue
        root = decorate(r, scene, item, mention(r, item), most=3)
        yield end(root, r.choice((".", ";", ",")))


@style("annotator", 4)
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


@style("groups", 1.5)
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


@style("predicates", 2)
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
