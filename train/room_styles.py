"""The manners in which room_sentences.py writes: each gets a random source and returns the trees of some sentences."""

from room_asides import with_effect
from room_basics import attach, end, mention
from room_brief import brief
from room_clauses import clause, gapped, inverted, listing, place_for, telegraphic_item, there_is, verb
from room_decorate import decorate
from room_phrases import room
from room_prose import annotator, groups, predicates
from room_scene import Scene
from tree_text import Node, join, prep

STYLES = {"brief": (brief, 5), "annotator": (annotator, 4), "groups": (groups, 1.5), "predicates": (predicates, 2)}


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
            places = place_for(r, scene, fact)
            fronted = places[0] if r.random() < 0.15 else None  # "Between the beds I want a nightstand."
            attach(members, places if fronted is None else [])
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
            if fronted is not None:
                root.first(*fronted)
            if r.random() < 0.25:
                inner = Node(r.choice(("have", "see", "put", "get", "add")), "VB").left("aux", Node("to", "TO")).right("dobj", members)
                root.right("xcomp", inner)
            else:
                root.right("dobj", members)
        elif chosen < 0.58:
            word = r.choice(("want", "like", "prefer", "need"))
            root = Node(word, "VBP" if word != "like" else "VB").left("nsubj", Node(r.choice(("i", "we", "they")), "PRP"))
            if word == "like":
                root.left("aux", Node("would", "MD"))
            inner = Node(r.choice(("go", "stand", "be", "sit", "face", "hang")), "VB")
            inner.left("nsubj", mention(r, fact.subject)).left("aux", Node("to", "TO"))
            if inner.word == "face":
                inner.right("dobj", mention(r, fact.other or fact.subject))
            else:
                if r.random() < 0.25 and inner.word == "be":
                    inner = Node("placed", "VBN").left("nsubjpass", inner.before[0][1])
                    inner.left("aux", Node("to", "TO")).left("auxpass", Node("be", "VB"))
                attach(inner, place_for(r, scene, fact))
            root.right("ccomp", inner)
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
