// The page of one query. SPDX-License-Identifier: MIT

for (const parent of document.querySelectorAll('.viewer')) {
  window.touchstoneViewer = startViewer(parent, dataOf(parent.dataset.picture), true);
}
