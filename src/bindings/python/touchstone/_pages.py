"""Pages as files. SPDX-License-Identifier: MIT"""
from __future__ import annotations

import mimetypes
import os
from pathlib import Path
from typing import Any, Protocol, Union

from ._hints import shown


class HasPage(Protocol):
    """Anything that shows itself as a page."""

    def page(self) -> str:
        """The text of an HTML file."""


def there(page: Any) -> Any:
    """A page, or the function that makes one. Raises RuntimeError in a build without pages, where it is None."""
    if page is None:
        raise RuntimeError("this module was built without pages: fmt or nlohmann-json was not found then")
    return page


def save_page(thing: HasPage, file: Union[str, "os.PathLike[str]"]) -> Path:
    """Writes the page of something into an HTML file, which a browser opens from disk and which needs nothing else.

    thing  what `show`, `show_mesh`, `certify` or `fuzz` returned, or a Finding or StepFinding: anything that has a method `page`
    file   the name of the file, such as refuted.html; one that is there is replaced

    Returns the file's Path. The file appears whole or not at all. Raises TypeError for a thing without a page,
    ValueError for a name with the ending of another format, RuntimeError in a build without pages, and OSError where
    the file cannot be written.

    >>> import tempfile, touchstone
    >>> found = touchstone.certify('point-point', [[[0, 0], [2, 0]]], [[[4, 0], [2, 0]]], [False])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     touchstone.save_page(found, folder + '/refuted.html').name
    'refuted.html'
    """
    if not callable(getattr(thing, "page", None)):
        raise TypeError(f"thing {shown(thing)}, which has no page; show, show_mesh, certify and fuzz return what has "
                        "one")
    path = Path(file)
    if mimetypes.guess_type(path.name) not in ((None, None), ("text/html", None)):
        raise ValueError(f"{path} has the ending of another format; what is written is a page, HTML with pictures "
                         f"(SVG) in it: name it {path.with_suffix('.html')}")
    text = thing.page()
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        with open(part, "w", encoding="utf-8", newline="\n") as out:
            out.write(text)
        os.replace(part, path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise
    return path
