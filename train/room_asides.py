"""What room descriptions add to their facts, as trees: purposes, effects, "with" clauses, "each with …"; for room_styles.py."""

from tree_text import Node, join, prep

EFFECTS = (
    ("providing", "storage space light comfort warmth seating contrast"),
    ("adding", "warmth style character charm color texture interest"),
    ("creating", "balance atmosphere harmony symmetry coziness corner"),
    ("offering", "space storage comfort seating privacy"),
    ("bringing", "light life warmth energy"),
    ("giving", "character depth"),
    ("completing", "look space setup arrangement"),
)
ADJECTIVES = [
    "ample",
    "extra",
    "additional",
    "cozy",
    "warm",
    "soft",
    "natural",
    "inviting",
    "elegant",
    "playful",
    "relaxed",
    "comfortable",
    "subtle",
    "modern",
]
PURPOSES = [
    "reading",
    "working",
    "relaxing",
    "studying",
    "dining",
    "storing",
    "playing",
    "entertaining",
    "cooking",
    "sleeping",
    "guests",
    "meals",
    "storage",
    "convenience",
    "comfort",
]
WIDE = ["space", "room", "area", "corner", "home", "bedroom", "kitchen", "setting"]


def abstract(r, word):
    node = Node(word, "NN")
    if r.random() < 0.5:
        node.left("amod", Node(r.choice(ADJECTIVES), "JJ"))
    if word in {"look", "space", "setup", "arrangement", "corner", "atmosphere"}:
        first = node.words()[0][0].word
        node.first("det", Node("the" if word != "corner" and word != "atmosphere" else ("an" if first[0] in "aeiou" else "a"), "DT"))
    return node


def to_the_room(r):
    return prep("to", Node(r.choice(WIDE), "NN").left("det", Node("the", "DT")))


def for_purpose(r):
    word = r.choice(PURPOSES)
    if word.endswith("ing"):
        return prep("for").right("pcomp", Node(word, "VBG"))
    node = Node(word, "NNS" if word in {"guests", "meals"} else "NN")
    if r.random() < 0.4:
        node.left("amod", Node(r.choice(("added", "easy", "quick", "everyday", "extra")), "JJ"))
    return prep("for", node)


def effect(r):
    """ "adding warmth and style to the space", "to create a cozy corner", "for reading\": (arc, node)."""
    chosen = r.random()
    if chosen < 0.5:
        word, objects = r.choice(EFFECTS)
        things = [abstract(r, name) for name in r.sample(objects.split(), 2 if r.random() < 0.3 else 1)]
        node = Node(word, "VBG").right("dobj", join(things))
        if word in {"adding", "bringing"}:
            node.right("prep", to_the_room(r))
        elif r.random() < 0.4:
            node.right("prep", for_purpose(r))
        return "advcl", node
    if chosen < 0.65:
        word = r.choice(("create", "provide", "add", "bring", "complete"))
        return "advcl", Node(word, "VB").left("aux", Node("to", "TO")).right(
            "dobj", abstract(r, r.choice(["warmth", "atmosphere", "storage", "light", "balance", "corner"]))
        )
    return "prep", for_purpose(r)


def with_effect(r, root):
    """Hangs an effect on a clause, after a comma where it is a clause itself."""
    arc, node = effect(r)
    if arc == "advcl" and node.tag == "VBG":
        root.right("punct", Node(",", "PUNCT"))
    return root.right(arc, node)


def each_with(r, phrase, held):
    """ "two nightstands, each with a lamp": `held` is the phrase of what each has."""
    phrase.right("punct", Node(",", "PUNCT"))
    each = Node("each", "DT")
    chosen = r.random()
    if chosen < 0.6:
        each.right("prep", prep("with", held))
    elif chosen < 0.8:
        each.right("acl", Node(r.choice(("holding", "featuring", "displaying", "supporting")), "VBG").right("dobj", held))
    else:
        each.right("acl", Node(r.choice(("topped", "equipped", "decorated", "paired")), "VBN").right("prep", prep("with", held)))
    return phrase.right("appos", each)


def one_of_which(r, phrase, held):
    """ "two shelves, one of which holds a clock\""""
    one = Node("one", "CD").right("prep", prep("of", Node("which", "WDT")))
    phrase.right("punct", Node(",", "PUNCT"))
    return phrase.right(
        "relcl", Node(r.choice(("holds", "supports", "carries", "displays", "has")), "VBZ").left("nsubj", one).right("dobj", held)
    )


def with_clause(r, root, phrase, places, verbs):
    """ ", with a mirror hanging above it\": `phrase` stands at `places`; `verbs` are what it may do there, each a word and its tag."""
    if r.random() < 0.65:
        root.right("punct", Node(",", "PUNCT"))
    host = phrase
    if verbs and r.random() < 0.65:
        host = Node(*r.choice(verbs))
        phrase.right("acl", host)
    for arc, node in places:
        host.right("acl" if arc == "advcl" and host is phrase else arc, node)
    return root.right("prep", prep("with", phrase))


def company(r, host, phrase):
    """ "accompanied by two chairs", "along with a lamp", "paired with a stool\""""
    chosen = r.random()
    if chosen < 0.3:
        return host.right("acl", Node(r.choice(("accompanied", "complemented")), "VBN").right("agent", prep("by", phrase)))
    if chosen < 0.6:
        return host.right("acl", Node(r.choice(("paired", "complete", "furnished")), "VBN").right("prep", prep("with", phrase)))
    return host.right("prep", prep(r.choice(("along with", "together with")), phrase))
