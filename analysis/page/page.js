// Sorting of tables, animations, and charts. Without this script the page is complete, but static.
(function () {
  'use strict';

  function keyOf(row, column) {
    var cell = row.cells[column], text = cell.textContent.trim();
    var number = parseFloat('value' in cell.dataset ? cell.dataset.value : text);
    return { text: text, number: isNaN(number) ? null : number };
  }

  function compare(a, b) {
    if (a.number !== null && b.number !== null) return a.number - b.number;
    if (a.number !== null || b.number !== null) return a.number === null ? 1 : -1;
    return a.text < b.text ? -1 : a.text > b.text ? 1 : 0;
  }

  function sort(table, head, column) {
    var down = head.getAttribute('aria-sort') === 'ascending', body = table.tBodies[0];
    var rows = Array.from(body.rows).map(function (row, place) {
      return { row: row, place: place, key: keyOf(row, column) };
    });
    rows.sort(function (a, b) { return (down ? compare(b.key, a.key) : compare(a.key, b.key)) || a.place - b.place; });
    rows.forEach(function (entry) { body.appendChild(entry.row); });
    Array.from(head.parentNode.cells).forEach(function (cell) { cell.removeAttribute('aria-sort'); });
    head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
  }

  function addSorting(table) {
    Array.from(table.tHead.rows[0].cells).forEach(function (head, column) {
      var button = shapes.make('button', { type: 'button' });
      while (head.firstChild) button.appendChild(head.firstChild);
      head.appendChild(button);
      button.addEventListener('click', function () { sort(table, head, column); });
    });
  }

  // A table that is wider than its place says so.
  function watchWidth(place) {
    new ResizeObserver(function () {
      place.classList.toggle('wide', place.scrollWidth > place.clientWidth + 1);
    }).observe(place);
  }

  // What is folded away has no width to draw in: it is drawn when it is opened.
  function whenSeen(holder) {
    var fold = holder.closest('details');
    if (!fold || fold.open) charts.add(holder);
    else fold.addEventListener('toggle', function () { charts.add(holder); }, { once: true });
  }

  // Paper has no folds; the experiment file and what is too much for the screen stay away from it, too.
  window.addEventListener('beforeprint', function () {
    document.querySelectorAll('figure > .folded, #trust .folded, .folded:has(> .settings)').forEach(function (fold) { fold.open = true; });
  });
  document.querySelectorAll('table.sortable').forEach(addSorting);
  document.querySelectorAll('.scroll').forEach(watchWidth);
  document.querySelectorAll('.motions').forEach(motions.add);
  if (typeof Dygraph === 'undefined') return;
  // The legend of dygraphs sets a style attribute, which the page's policy forbids; the readout shows the same.
  Dygraph.PLUGINS = Dygraph.PLUGINS.filter(function (plugin) { return plugin !== Dygraph.Plugins.Legend; });
  document.documentElement.classList.add('live');
  document.querySelectorAll('.charts').forEach(whenSeen);
}());
