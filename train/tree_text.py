"""Sentences built as trees: every word knows its tag, its head and the label of the arc between them."""


class Node:
    """A word with what hangs on it: children to its left and right in the order of the text."""

    def __init__(self, word, tag, glued=False):
        self.word, self.tag, self.glued = word, tag, glued  # glued: a hyphen before it
        self.before, self.after = [], []

    def left(self, arc, node):
        self.before.append((arc, node))
        return self

    def right(self, arc, node):
        self.after.append((arc, node))
        return self

    def first(self, arc, node):
        """Like left(), before all else that is there."""
        self.before.insert(0, (arc, node))
        return self

    def words(self):
        """All words below and this one in the order of the text: (node, head or None, arc)."""
        rows = []

        def walk(node, head, arc):
            for label, child in node.before:
                walk(child, node, label)
            rows.append((node, head, arc))
            for label, child in node.after:
                walk(child, node, label)

        walk(self, None, "root")
        return rows


def trees(root):
    """Lines of word, tag, head and label as syntax_train reads them."""
    rows = root.words()
    place = {id(node): i + 1 for i, (node, _, _) in enumerate(rows)}
    return "".join(f"{node.word.lower()}\t{node.tag}\t{place[id(head)] if head else 0}\t{arc}\n" for node, head, arc in rows) + "\n"


def text(root):
    """As it is written."""
    result = ""
    for node, _, _ in root.words():
        if node.glued:
            result += "-" + node.word
        elif node.word in {",", ".", ";", ":", "!", "?", ")", "'s"}:
            result += node.word
        else:
            result += ("" if not result or result.endswith("(") else " ") + node.word
    return result[:1].upper() + result[1:]


TAGS = {
    "a": "DT",
    "an": "DT",
    "the": "DT",
    "each": "DT",
    "every": "DT",
    "some": "DT",
    "this": "DT",
    "that": "DT",
    "another": "DT",
    "no": "DT",
    "either": "DT",
    "both": "DT",
    "these": "DT",
    "its": "PRP$",
    "my": "PRP$",
    "their": "PRP$",
    "our": "PRP$",
}


def phrase(*parts):
    """A chain of (arc, word, tag) to one node each, for words without children."""
    return [(arc, Node(word, tag)) for arc, word, tag in parts]


def comma(host, after=True):
    node = ("punct", Node(",", "PUNCT"))
    (host.after if after else host.before).append(node)
    return host


def join(nodes, conjunction="and", oxford=False, comma_only=False):
    """A list: each member hangs on the one before; "and" and commas on the member before them."""
    head = nodes[0]
    for i in range(1, len(nodes)):
        before, last = nodes[i - 1], i == len(nodes) - 1
        if not last or comma_only or (oxford and len(nodes) > 2):
            before.right("punct", Node(",", "PUNCT"))
        if last and not comma_only:
            before.right("cc", Node(conjunction, "CC"))
        before.right("conj", nodes[i])
    return head


def prep(word, pobj=None, tag="IN"):
    """A preposition of one word or of several whose first is the head ("across from")."""
    first, *others = word.split()
    node = Node(first, tag)
    last = node
    for other in others:
        following = Node(other, "IN")
        last.right("prep", following)
        last = following
    if pobj is not None:
        last.right("pobj", pobj)
    return node
