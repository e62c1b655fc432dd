// The page of a fuzzer's findings: one card at a time moves, because browsers have few WebGL contexts.
// SPDX-License-Identifier: MIT

let liveViewer = null;

function stillAgain() {
  if (liveViewer) liveViewer.stop();
  liveViewer = null;
  document.querySelectorAll('.mover').forEach((button) => button.hidden = false);
}

for (const parent of document.querySelectorAll('.viewer')) {
  const button = element(
      'button', {
        type: 'button',
        class: 'mover',
        onclick: () => {
          stillAgain();
          button.hidden = true;
          liveViewer = startViewer(parent, dataOf(parent.dataset.picture));
          window.touchstoneViewer = liveViewer;
        }
      },
      'Move it');
  parent.querySelector('.stage').append(button);
}
