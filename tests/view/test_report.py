"""The page of a comparison of methods in a real browser. SPDX-License-Identifier: MIT

  test_report.py TOUCHSTONE
"""
import os
import unittest

import pages


class Reports(pages.Pages):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.out = os.path.join(cls.folder.name, "report.html")
        cls.run_program(cls("run_program"), "report", "--quick", "--out", os.path.join(cls.folder.name, "report"),
                        "--html", cls.out)

    def column(self, number):
        """The cells of a column of the first table."""
        return self.page.evaluate("[...document.querySelector('table.sorts').tBodies[0].rows].map((r) => "
                                  "r.children[%d].textContent)" % number)

    def test_every_set_has_its_pictures_and_its_table(self):
        url = self.page.open(self.out)
        with open(os.path.join(self.folder.name, "report", "report.md"), encoding="utf-8") as file:
            report = file.read()
        names = self.page.evaluate("[...document.querySelectorAll('.set h2')].map((h) => h.textContent)")
        self.assertGreater(len(names), 4)
        for name in names:
            self.assertIn("## %s\n" % name, report)
        sets = self.page.evaluate("[...document.querySelectorAll('.set')].map((s) => [s.querySelectorAll('svg').length,"
                                  " s.querySelectorAll('svg:first-of-type .dot').length, s.querySelectorAll('tbody tr')"
                                  ".length])")
        for svgs, dots, rows in sets:
            self.assertEqual(svgs, 2)
            self.assertGreaterEqual(dots, rows)  # the first picture has all methods
        # The text and the table say the same as the other files of the report.
        self.assertIn("is wrong on 0 of", self.text("main"))
        self.assertNotIn("*", self.text("main"))  # no mark of a Markdown file
        self.page.evaluate("document.querySelector('details').open = true")
        self.assertIn("Missed: contact denied though there is one", self.text("details"))
        # Each picture names our own method. On a slow machine it has the share that it was asked, "touchstone (3 of 4)",
        # and if there is no contact among them it has no time error, which the second picture is about.
        named = self.page.evaluate("[...document.querySelectorAll('.set')].map((s) => [...s.querySelectorAll('svg')]."
                                   "every((p, i) => (i === 1 && !s.querySelector('tr.own').cells[6].textContent) || "
                                   "[...p.querySelectorAll('text')].some((t) => /^touchstone\\b/.test("
                                   "t.textContent))))")
        self.assertTrue(all(named), named)
        cells = self.page.evaluate("[...document.querySelector('table.sorts tr.own').children].map((c) => "
                                   "c.textContent)")
        self.assertIn("| touchstone | | %s |" % " | ".join(cells[1:6]), report.replace("|  |", "| |"))
        self.check_quiet(url)

    def test_tables_sort_by_numbers_and_names(self):
        url = self.page.open(self.out)
        heads = self.page.evaluate("[...document.querySelectorAll('.set:first-of-type thead th')].map((h) => "
                                   "h.textContent)")
        means = heads.index("mean us")
        click = "document.querySelectorAll('table.sorts')[0].tHead.rows[0].cells[%d].querySelector('button')"
        self.page.click_on(click % means)
        rising = [float(x) for x in self.column(means)]
        self.assertEqual(rising, sorted(rising))
        self.page.click_on(click % means)
        falling = [float(x) for x in self.column(means)]
        self.assertEqual(falling, sorted(rising, reverse=True))
        self.assertNotEqual(rising, falling)
        self.assertEqual(self.page.evaluate((click % means) + ".parentNode.getAttribute('aria-sort')"), "descending")
        self.page.click_on(click % 0)
        names = self.column(0)
        self.assertEqual(names, sorted(names, key=lambda name: (name.lower(), name)))
        # Negative numbers are less than small ones, and empty cells come last.
        earliest = heads.index("earliest")
        self.page.click_on(click % earliest)
        cells = self.column(earliest)
        values = [float(x) for x in cells if x]
        self.assertEqual(values, sorted(values))
        self.assertEqual(cells, [c for c in cells if c] + [c for c in cells if not c])
        self.check_quiet(url)

    def test_a_point_tells_its_method_and_its_row(self):
        url = self.page.open(self.out)
        dot = "document.querySelector('.dot.own')"
        self.page.evaluate("%s.scrollIntoView({block: 'center'})" % dot)
        left, top, width, height = self.page.evaluate(
            "(() => { const b = %s.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()" % dot)
        self.page.command("Input.dispatchMouseEvent", type="mouseMoved", x=left + width / 2, y=top + height / 2)
        told = self.page.evaluate("document.querySelector('.told').textContent")
        self.assertRegex(told, r"^touchstone: [\d.]+ us a query, 0 ")
        self.assertEqual(self.page.evaluate("[...document.querySelectorAll('tr.here th')].map((h) => h.textContent)"),
                         ["touchstone"])
        self.assertEqual(self.page.evaluate("document.querySelectorAll('.dot.here').length"), 2)
        row = "document.querySelector('tbody tr:not(.own)')"
        self.page.evaluate("%s.scrollIntoView({block: 'center'})" % row)
        left, top, width, height = self.page.evaluate(
            "(() => { const b = %s.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()" % row)
        self.page.command("Input.dispatchMouseEvent", type="mouseMoved", x=left + 20, y=top + height / 2)
        self.assertTrue(self.page.evaluate("%s.classList.contains('here')" % row))
        self.assertEqual(self.page.evaluate("document.querySelectorAll('.dot.here.own').length"), 0)
        self.check_quiet(url)

    def test_a_telephone_and_the_dark(self):
        self.page.window(390, 844, dark=True, touch=True)
        url = self.page.open(self.out)
        self.assertLessEqual(self.page.evaluate("document.documentElement.scrollWidth"), 390)
        self.assertEqual(self.page.evaluate("getComputedStyle(document.body).backgroundColor"), "rgb(20, 23, 27)")
        self.assertGreater(self.page.evaluate("document.querySelector('.chart').getBoundingClientRect().width"), 300)
        self.check_quiet(url)


if __name__ == "__main__":
    unittest.main(verbosity=1)
