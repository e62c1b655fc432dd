"""Results as tables of pandas. SPDX-License-Identifier: MIT"""
from __future__ import annotations

from typing import Any

from ._core import Answers, BodyIntersections, BodyPairs, Distances, FuzzReport, Intersections, Pairs
from ._names import Feature, Level, Nature, Trend


def frame(columns) -> Any:
    try:
        import pandas  # type: ignore[import]
    except ImportError:
        raise ImportError("to_pandas needs pandas (pip install pandas, or Debian's python3-pandas)") from None
    return pandas.DataFrame(columns)


def _weights(name, weights):
    return {f"{name}{i}": weights[:, i] for i in range(3)}


def answer_columns(answers):
    """The columns of the table of Answers, by their names."""
    return {"contact": answers.contact, "toi": answers.toi, "toi_upper": answers.toi_upper,
            "nature": Nature.names(answers.nature), "feature_a": Feature.names(answers.feature_a),
            "feature_b": Feature.names(answers.feature_b), "level": Level.names(answers.level),
            "trend": Trend.names(answers.trend), "starts_within": answers.starts_within,
            **_weights("a", answers.weights_a), **_weights("b", answers.weights_b)}


def _answers_table(self) -> Any:
    """A pandas.DataFrame with a row for each answer, in which natures, features, levels and trends are names, and the
    weights are a0 a1 a2 b0 b1 b2. Raises ImportError without pandas."""
    return frame(answer_columns(self))


def _distances_table(self) -> Any:
    """A pandas.DataFrame with a row for each distance, in which features are names, and the weights are a0 a1 a2 b0 b1
    b2. Raises ImportError without pandas."""
    return frame({"value": self.value, "feature_a": Feature.names(self.feature_a),
                   "feature_b": Feature.names(self.feature_b), **_weights("a", self.weights_a),
                   **_weights("b", self.weights_b)})


def _columns(of, *names):
    return {name: getattr(of, name) for name in names if hasattr(of, name)}


def _pairs_table(self) -> Any:
    """A pandas.DataFrame with a row for each pair, and for each contact with its separation and its answer. Raises
    ImportError without pandas."""
    contact = {"separation": self.separation, **answer_columns(self.answers)} if len(self.separation) else {}
    return frame({**_columns(self, "kind", "first_body", "first", "second_body", "second"), **contact})


def _intersections_table(self) -> Any:
    """A pandas.DataFrame with a row for each intersection; the weights of the common point of a mesh's elements are a0
    a1 a2 b0 b1 b2. Raises ImportError without pandas."""
    weights = {**_weights("a", self.weights_first), **_weights("b", self.weights_second)} \
        if hasattr(self, "weights_first") else {}
    return frame({**_columns(self, "first_element", "first_body", "first", "second_element", "second_body", "second",
                             "sort"), **weights})


def _findings_table(self) -> Any:
    """A pandas.DataFrame with a row for each finding. `exact_contact` and `exact_toi` are the exact answer to the
    shrunk query. Raises ImportError without pandas."""
    names = ("failure", "count", "kind", "degeneracy", "start", "end", "contact", "toi")
    columns = {name: [getattr(found, name) for found in self.findings] for name in names}
    columns["exact_contact"] = [found.truth.contact for found in self.findings]
    columns["exact_toi"] = [found.truth.toi for found in self.findings]
    for name in ("detail", "case_name", "separation", "metric"):
        columns[name] = [getattr(found, name) for found in self.findings]
    return frame(columns)


for _class, _method in ((Answers, _answers_table), (Distances, _distances_table), (Pairs, _pairs_table),
                        (BodyPairs, _pairs_table), (Intersections, _intersections_table),
                        (BodyIntersections, _intersections_table), (FuzzReport, _findings_table)):
    setattr(_class, "to_pandas", _method)
