"""Formulas of w, d, h and i, as catalog/*.json give the bounds of spaces in (check_catalog.py)."""

from __future__ import annotations

import ast
import operator

Size = dict[str, float]
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}


def evaluate(formula: str, values: Size) -> float:
    """The value in metres of a formula of w, d, h and i; ValueError for anything else."""

    def walk(node: ast.AST) -> float:
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
            return node.value
        if isinstance(node, ast.Name) and node.id in values:
            return values[node.id]
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -walk(node.operand)
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            return OPERATORS[type(node.op)](walk(node.left), walk(node.right))
        raise ValueError(f"'{formula}' is not a formula of w, d, h and i")

    try:
        return walk(ast.parse(formula, mode="eval").body)
    except SyntaxError as error:
        raise ValueError(f"'{formula}' is not a formula: {error.msg}") from error


def is_linear(formula: str) -> bool:
    """True when doubling a difference in w, d or h doubles the difference in value."""
    base, point, twice = ({"w": a, "d": b, "h": c, "i": 1} for a, b, c in ((1, 1, 1), (2, 3, 4), (3, 5, 7)))
    low, middle, high = (evaluate(formula, values) for values in (base, point, twice))
    return abs((high - middle) - (middle - low)) < 1e-9
