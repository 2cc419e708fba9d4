// Buttons that hand out what the page holds: the text of a script element as a file.
(() => {
  'use strict';
  for (const button of document.querySelectorAll('button[data-download]')) {
    button.hidden = false;
    button.addEventListener('click', () => {
      const text = document.getElementById(button.dataset.download).textContent;
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([text], {type: button.dataset.type}));
      link.download = button.dataset.name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }
})();
