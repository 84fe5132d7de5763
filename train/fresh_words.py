"""Words for things of a scene, as all manners of writing use them (fresh_styles.py)."""

NUMBERS = {2: "two", 3: "three", 4: "four", 6: "six"}


def plural(name):
    return name + "es" if name.endswith(("ch", "s", "sh")) else name[:-3] + "ves" if name.endswith("elf") else name + "s"


def article(words):
    return ("an " if words[0] in "aeiou" else "a ") + words


def new(r, thing, digits=False):
    """ "a blue lamp", "three books", "the lamp" where it was spoken of."""
    if hasattr(thing, "thing"):
        return "it"
    look = f"{thing.look} " if thing.look and not thing.said else ""
    known, thing.said = thing.said, True
    if known:
        return "the " + (thing.name if thing.number == 1 else plural(thing.name))
    if thing.number == 1:
        return article(look + thing.name)
    return f"{thing.number if digits else NUMBERS[thing.number]} {look}{plural(thing.name)}"


def be(thing):
    return "is" if thing.number == 1 else "are"


def s(thing, verb):
    return verb + ("s" if thing.number == 1 else "")


def where(r, kind, other, words):
    """A place as a phrase, `words` giving the manner's choices by kind."""
    form = r.choice(words[kind])
    if isinstance(other, str):
        return form.format(w=other)
    return form.format(o=new(r, other))


def pairs(r, facts, share=0.4):
    """Facts one by one or two at a time."""
    facts = list(facts)
    while facts:
        taken = facts[: 2 if r.random() < share else 1]
        del facts[: len(taken)]
        yield taken
