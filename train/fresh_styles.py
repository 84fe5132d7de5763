"""Manners of writing for fresh_rooms.py: each makes a text of a scene. None of them is among what the parser learned from."""

from fresh_words import be, new, pairs, plural, s, where

STYLES = {}


def style(function):
    STYLES[function.__name__] = function
    return function


PLAIN = {
    "on": ["on {o}", "on top of {o}"],
    "nextTo": ["next to {o}", "beside {o}"],
    "leftOf": ["to the left of {o}"],
    "rightOf": ["to the right of {o}"],
    "behind": ["behind {o}"],
    "opposite": ["opposite {o}", "across from {o}"],
    "inFrontOf": ["in front of {o}"],
    "around": ["around {o}"],
    "sides": ["on either side of {o}", "on both sides of {o}"],
    "above": ["above {o}", "over {o}"],
    "under": ["under {o}", "beneath {o}"],
    "wall": ["against the {w} wall", "along the {w} wall"],
    "corner": ["in the corner", "in a corner of the room"],
    "window": ["by the window", "under the window"],
}
HANGING = {"mirror", "painting", "poster", "pendant lamp"}


def verb_for(r, thing, kind):
    if kind == "above" and thing.name in HANGING:
        return s(thing, "hang")
    if kind == "under":
        return s(thing, "lie")
    return r.choice([s(thing, "stand"), s(thing, "sit"), s(thing, "rest"), be(thing)])


@style
def fivesentence(r, scene):
    """A room in about five long sentences, two or three facts in each."""
    clauses, text = [], f"This {scene.room} is easy to picture. "
    for kind, subject, other in scene.facts:
        chosen = r.random()
        if chosen < 0.2 and kind == "on":
            host = new(r, other)
            clauses.append(f"{host} {r.choice(('holds', 'supports', 'carries'))} {new(r, subject)}")
        elif chosen < 0.45 and other is not subject and kind not in {"wall", "window"}:
            place = where(r, kind, other, PLAIN)
            clauses.append(f"{place} {verb_for(r, subject, kind)} {new(r, subject)}")
        elif chosen < 0.65:
            name = new(r, subject)
            done = "hung" if kind == "above" else "laid" if kind == "under" else r.choice(("placed", "positioned", "arranged"))
            clauses.append(f"{name} {be(subject)} {done} {where(r, kind, other, PLAIN)}")
        else:
            name = new(r, subject)
            clauses.append(f"{name} {verb_for(r, subject, kind)} {where(r, kind, other, PLAIN)}")
    joins = (", and ", ", while ", "; ", ". ")
    while clauses:
        part = clauses.pop(0)
        text += part[0].upper() + part[1:]
        while clauses and (join := r.choice(joins)) != ". ":
            text += join + clauses.pop(0)
        text += ". "
    return text.strip()


@style
def tabletop(r, scene):
    """Hosts first, with all that stands on them."""
    text = []
    hosted = {}
    for kind, subject, other in scene.facts:
        hosted.setdefault("rest" if isinstance(other, str) or kind != "on" else other.name, []).append((kind, subject, other))
    for host, facts in hosted.items():
        if host == "rest":
            continue
        other = facts[0][2]
        things = [new(r, subject) for _, subject, _ in facts]
        listed = things[0] if len(things) == 1 else ", ".join(things[:-1]) + " and " + things[-1]
        form = r.choice(("{h} has {t} on it.", "On {h} there are {t}.", "{t} can be found on {h}.", "You can see {t} on top of {h}."))
        if len(things) == 1 and facts[0][1].number == 1:
            form = form.replace("there are", "there is")
        sentence = form.format(h=new(r, other), t=listed)
        text.append(sentence[0].upper() + sentence[1:])
    for kind, subject, other in hosted.get("rest", []):
        name = new(r, subject)
        sentence = f"{name} {be(subject)} {where(r, kind, other, PLAIN)}."
        text.append(sentence[0].upper() + sentence[1:])
    return f"A {scene.room}. " + " ".join(text)


ESTATE = {
    **PLAIN,
    "nextTo": ["next to {o}", "right beside {o}"],
    "wall": ["along the {w} wall", "against the {w} wall"],
    "corner": ["in the corner"],
    "window": ["by the window", "under the window"],
    "opposite": ["opposite {o}", "directly across from {o}"],
}


def estate_pair(r, first, second):
    """Two facts in one sentence."""
    form = r.choice(("{0} {1} {2}, while {3} {4} {5}.", "{0} {1} {2}, with {3} {5}.", "{2}, {0} {1}, and {3} {4} {5}."))
    verbs = ("stand proudly", "sit invitingly", "take center stage", "rest")
    if form.startswith("{2}"):
        place = where(r, first[0], first[2], ESTATE)
        name = new(r, first[1])
    else:
        name = new(r, first[1])
        place = where(r, first[0], first[2], ESTATE)
    words = []
    for fact in (first, second):
        verb, *rest = r.choice(verbs).split(" ", 1)
        words.append(" ".join([s(fact[1], verb), *rest]))
    after = new(r, second[1])
    sentence = form.format(name, words[0], place, after, words[1], where(r, second[0], second[2], ESTATE))
    return sentence[0].upper() + sentence[1:]


@style
def estate(r, scene):
    """What an agent writes."""
    opening = r.choice(("Step into this delightful {}!", "A truly charming {} awaits.", "You will love the sun-filled {}."))
    text = [opening.format(scene.room)]
    for taken in pairs(r, scene.facts, 0.35):
        if len(taken) == 2:
            text.append(estate_pair(r, *taken))
            continue
        kind, subject, other = taken[0]
        form = r.choice(
            (
                "{S} takes its place {P}.",
                "{S} sits beautifully {P}.",
                "{S} awaits you {P}.",
                "You will find {S} {P}.",
                "{P}, {S} invites you in.",
                "Enjoy {S} {P}.",
            )
        )
        if subject.number != 1:
            form = (
                form.replace("takes its place", "take their place")
                .replace("sits", "sit")
                .replace("awaits", "await")
                .replace("invites", "invite")
            )
        if kind == "above":
            form = "{S} hang{s} {P}." if r.random() < 0.5 else "{P} hang{s} {S}."
        first = form.index("{S}") < form.index("{P}")
        if first:
            name = new(r, subject)
            place = where(r, kind, other, ESTATE)
        else:
            place = where(r, kind, other, ESTATE)
            name = new(r, subject)
        sentence = form.format(S=name, P=place, s="s" if subject.number == 1 else "")
        text.append(sentence[0].upper() + sentence[1:])
    return " ".join(text)


@style
def bullets(r, scene):
    """A list, a thing a line."""
    lines = [scene.room.capitalize() + ":"]
    for kind, subject, other in scene.facts:
        look = f"{subject.look} " if subject.look and not subject.said else ""
        known, subject.said = subject.said, True
        name = look + (subject.name if subject.number == 1 else plural(subject.name))
        count = "" if subject.number == 1 or known else f"{subject.number} "
        place = where(r, kind, other, {**PLAIN, "wall": ["{w} wall", "against {w} wall"]})
        lines.append(r.choice(("- {}{}, {}", "- {}{} {}", "- {}{}: {}")).format(count, name, place))
    return "\n".join(lines)


@style
def child(r, scene):
    """A child's wish list."""
    text = [f"In my {scene.room} I want lots of stuff."]
    for taken in pairs(r, scene.facts, 0.3):
        kind, subject, other = taken[0]
        name = new(r, subject)
        place = where(r, kind, other, PLAIN)
        if len(taken) == 2:
            second = f"{new(r, taken[1][1])} {where(r, taken[1][0], taken[1][2], PLAIN)}"
            text.append(
                r.choice(("I want {} {} and {}!", "I need {} {} and also {}.", "Can I have {} {} and {}?")).format(name, place, second)
            )
            continue
        pronoun = "it" if subject.number == 1 else "they"
        form = r.choice(
            (
                "I want {S} and put {T} {P} please.",
                "{S} should go {P}.",
                "There has to be {S} {P}!",
                "And {S}, and {t} must be {P}.",
                "Then {S} {P}, okay?",
            )
        )
        sentence = form.format(S=name, P=place, T="it" if subject.number == 1 else "them", t=pronoun)
        text.append(sentence[0].upper() + sentence[1:])
    return " ".join(text)


BROKEN = {
    **PLAIN,
    "on": ["on {o}", "upon {o}"],
    "nextTo": ["near to {o}", "beside of {o}", "next to {o}"],
    "leftOf": ["at the left side of {o}", "on left of {o}"],
    "rightOf": ["at the right side of {o}", "on right of {o}"],
    "opposite": ["opposite to {o}", "opposite of {o}"],
    "around": ["around of {o}", "around {o}"],
    "sides": ["at both sides of {o}"],
    "wall": ["at the {w} wall", "on the {w} side wall"],
    "window": ["near to the window", "below the window"],
}


@style
def nonnative(r, scene):
    """English as a second language."""
    text = [f"It is a {scene.room}."]
    for kind, subject, other in scene.facts:
        form = r.choice(
            (
                "{P} it is {S}.",
                "{P} is standing {S}.",
                "There is located {S} {P}.",
                "{S} is putted {P}.",
                "{S} stay {P}.",
                "Also we have {S} which is {P}.",
            )
        )
        if kind == "above":
            form = r.choice(("{P} is hanging {S}.", "{S} is hanged {P}."))
        if form.index("{S}") < form.index("{P}"):
            name = new(r, subject)
            place = where(r, kind, other, BROKEN)
        else:
            place = where(r, kind, other, BROKEN)
            name = new(r, subject)
        if subject.number != 1:
            form = form.replace(" is ", " are ").replace("There are located", "There are located")
        sentence = form.format(S=name, P=place)
        text.append(sentence[0].upper() + sentence[1:])
    return " ".join(text)


@style
def letter(r, scene):
    """A customer writes to a furnisher."""
    text = [f"Hello, this is about our {scene.room}."]
    for taken in pairs(r, scene.facts):
        kind, subject, other = taken[0]
        name = new(r, subject)
        place = where(r, kind, other, PLAIN)
        if len(taken) == 2:
            second = f"{new(r, taken[1][1])} {where(r, taken[1][0], taken[1][2], PLAIN)}"
            form = r.choice(
                (
                    "Could you put {S} {P} and {T}?",
                    "We would like {S} {P} and {T}.",
                    "Please place {S} {P}, and {T}.",
                    "My husband imagines {S} {P} and {T}.",
                )
            )
            text.append(form.format(S=name, P=place, T=second))
            continue
        form = r.choice(
            (
                "We would like {S} to go {P}.",
                "Could you put {S} {P}?",
                "My wife wants {S} {P}.",
                "We are thinking of {S} {P}.",
                "What we need is {S} {P}.",
                "Please have {S} placed {P}.",
                "It would be nice if {S} stood {P}.",
            )
        )
        text.append(form.format(S=name, P=place))
    return " ".join(text)
