// What makes a page live: charts that zoom and tell their values, tables that sort. Without it the page is whole too.
(function () {
  'use strict';

  var dashes = { 1: [], 2: [8, 4], 3: [2, 3], 4: [8, 3, 2, 3], 5: [8, 3, 2, 3, 2, 3] };

  function make(tag, attributes, parent) {
    var element = document.createElement(tag);
    Object.keys(attributes || {}).forEach(function (name) {
      if (name === 'text') element.textContent = attributes.text;
      else element.setAttribute(name, attributes[name]);
    });
    if (parent) parent.appendChild(element);
    return element;
  }

  // ---- numbers and labels

  function brief(number) {
    if (number === null || !isFinite(number)) return 'none';
    return String(Number(number.toPrecision(4)));
  }

  function safe(text) {
    return text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');
  }

  // As HTML, for dygraphs takes labels so.
  function labelOf(axis) {
    var symbol = axis.symbol && '<i>' + safe(axis.symbol).replace(/_([A-Za-z0-9]+)/g, '<sub>$1</sub>') + '</i>';
    return [safe(axis.quantity), symbol, axis.unit ? '[' + safe(axis.unit) + ']' : ''].filter(Boolean).join(' ');
  }

  // ---- looks

  function hatched(context, layer) {
    var lines = { 1: [1, -1], 2: [1, -1], 4: [1], 5: [-1], 6: [2], 7: [-2] }[layer.hatch] || [];
    if (lines.length === 0) return null;
    var size = layer.hatch === 2 ? 5 : 9;
    var tile = document.createElement('canvas');
    tile.width = size;
    tile.height = size * 2;
    var pen = tile.getContext('2d');
    pen.strokeStyle = 'rgba(0, 0, 0, 0.55)';
    pen.lineWidth = 1;
    lines.forEach(function (slope) {
      var rise = size * slope;
      for (var start = -4 * size; start <= 6 * size; start += Math.abs(slope) > 1 ? 2 * size : size) {
        pen.beginPath();
        pen.moveTo(0, start);
        pen.lineTo(size, start + rise);
        pen.stroke();
      }
    });
    return context.createPattern(tile, 'repeat');
  }

  function fillBox(context, layer, x, y, width, height) {
    context.globalAlpha = layer.opacity;
    context.fillStyle = layer.colour;
    context.fillRect(x, y, width, height);
    context.globalAlpha = 1;
    var pattern = hatched(context, layer);
    if (pattern) {
      context.fillStyle = pattern;
      context.fillRect(x, y, width, height);
    }
    context.strokeStyle = 'rgba(0, 0, 0, 0.35)';
    context.lineWidth = 0.5;
    context.strokeRect(x, y, width, height);
  }

  // gnuplot's point types: 4 to 15 in pairs, open and filled.
  function mark(context, x, y, colour, size, marker) {
    var sides = { 4: 4, 5: 4, 8: 3, 9: 3, 10: -3, 11: -3, 12: 4, 13: 4, 14: 5, 15: 5 }[marker];
    context.beginPath();
    context.strokeStyle = colour;
    context.fillStyle = colour;
    context.lineWidth = 1.3;
    if (marker <= 3) {
      if (marker !== 2) { context.moveTo(x - size, y); context.lineTo(x + size, y); context.moveTo(x, y - size); context.lineTo(x, y + size); }
      if (marker !== 1) { context.moveTo(x - size, y - size); context.lineTo(x + size, y + size); context.moveTo(x - size, y + size); context.lineTo(x + size, y - size); }
      context.stroke();
      return;
    }
    if (!sides) {
      context.arc(x, y, size, 0, 2 * Math.PI);
    } else {
      var turn = marker === 4 || marker === 5 ? Math.PI / 4 : 0;
      for (var i = 0; i < Math.abs(sides); ++i) {
        var angle = turn + 2 * Math.PI * i / Math.abs(sides);
        context.lineTo(x + 1.2 * size * Math.sin(angle), y - 1.2 * size * Math.cos(angle) * Math.sign(sides));
      }
      context.closePath();
    }
    if (marker === 7 || (sides && marker % 2 === 1)) context.fill();
    else { context.fillStyle = '#fff'; context.fill(); context.stroke(); }
  }

  function sample(layer) {
    var canvas = make('canvas', { 'aria-hidden': 'true', width: 30, height: 14 });
    var context = canvas.getContext('2d');
    if (layer.kind === 'boxes' || layer.kind === 'spans') {
      fillBox(context, layer, 1, 1, 28, 12);
    } else {
      context.strokeStyle = darkened(layer.colour);
      context.lineWidth = 2;
      context.setLineDash(dashes[layer.dash] || []);
      context.beginPath();
      context.moveTo(0, 7);
      context.lineTo(30, 7);
      context.stroke();
      context.setLineDash([]);
      mark(context, 15, 7, darkened(layer.colour), 4, layer.marker);
    }
    return canvas;
  }

  // ---- charts

  function extent(panel, axis, columnsOf) {
    var low = Infinity, high = -Infinity;
    panel.layers.forEach(function (layer) {
      columnsOf(layer).forEach(function (column) {
        column.forEach(function (number) {
          if (number === null) return;
          low = Math.min(low, number);
          high = Math.max(high, number);
        });
      });
    });
    if (low > high) { low = 0; high = 1; }
    if (axis.low !== null) low = axis.low;
    if (axis.high !== null) high = axis.high;
    var margin = low === high ? 1 : 0.02 * (high - low);
    return [low - margin, high + margin];
  }

  var isCurve = { line: true, points: true, steps: true };

  function xColumns(layer) { return isCurve[layer.kind] || layer.kind === 'ribbon' || layer.kind === 'error_bars' ? layer.columns.slice(0, 1) : layer.columns.slice(0, 2); }
  function yColumns(layer) {
    if (layer.kind === 'spans') return [];
    return isCurve[layer.kind] || layer.kind === 'ribbon' || layer.kind === 'error_bars' ? layer.columns.slice(1) : layer.columns.slice(2);
  }

  // The interval that belongs to a curve: a ribbon or error bars of the same group.
  function intervalOf(panel, curve) {
    var found = panel.layers.filter(function (layer) {
      return (layer.kind === 'ribbon' || layer.kind === 'error_bars') && layer.group === curve.group;
    })[0];
    if (!found) return null;
    var columns = found.columns.slice(-2), at = {};
    found.columns[0].forEach(function (x, i) { at[x] = [columns[0][i], columns[1][i]]; });
    return at;
  }

  // A pale colour that fills an area well is lost as a line.
  function darkened(colour) {
    var parts = [1, 3, 5].map(function (at) { return parseInt(colour.slice(at, at + 2), 16); });
    return 0.3 * parts[0] + 0.6 * parts[1] + 0.1 * parts[2] > 180 ? '#767676' : colour;
  }

  // Curves with their intervals as dygraphs takes them: rows of x and [low, y, high].
  function seriesOf(panel) {
    var curves = panel.layers.filter(function (layer) { return isCurve[layer.kind]; });
    var bars = panel.layers.filter(function (layer) {
      return layer.kind === 'error_bars' && !curves.some(function (curve) { return curve.group === layer.group; });
    });
    curves = curves.concat(bars);
    var rows = new Map();
    curves.forEach(function (curve, place) {
      var interval = curve.kind === 'error_bars' ? null : intervalOf(panel, curve);
      curve.columns[0].forEach(function (x, i) {
        if (x === null) return;
        if (!rows.has(x)) rows.set(x, curves.map(function () { return [null, null, null]; }));
        var y = curve.columns[1][i];
        var ends = curve.kind === 'error_bars' ? [curve.columns[2][i], curve.columns[3][i]] : interval && interval[x];
        rows.get(x)[place] = y === null ? [null, null, null] : ends && ends[0] !== null ? [ends[0], y, ends[1]] : [y, y, y];
      });
    });
    var xs = Array.from(rows.keys()).sort(function (a, b) { return a - b; });
    return { curves: curves, xs: xs, rows: xs.map(function (x) { return [x].concat(rows.get(x)); }) };
  }

  function Chart(panel, figure, parent) {
    this.panel = panel;
    this.hidden = {};
    this.series = seriesOf(panel);
    this.boxes = panel.layers.filter(function (layer) { return layer.kind === 'boxes' || layer.kind === 'spans'; });
    this.home = { dateWindow: extent(panel, panel.x, xColumns), valueRange: extent(panel, panel.y, yColumns) };
    var holder = make('div', { class: 'panel' }, parent);
    if (panel.title) make('h4', { text: panel.title }, holder);
    this.frame = make('div', { class: 'frame', tabindex: '0', role: 'group', 'aria-roledescription': 'chart',
      'aria-label': (panel.title ? panel.title + ': ' : '') + panel.y.quantity + ' against ' + panel.x.quantity +
        '. Arrow keys move along it and read its values; plus and minus zoom, 0 shows all. The table below has the numbers.' }, holder);
    this.plot = make('div', { class: 'plot' }, this.frame);
    this.cursor = make('div', { class: 'cursor', hidden: '' }, this.frame);
    var foot = make('div', { class: 'foot' }, holder);
    this.readout = make('output', { class: 'readout', text: 'Point at the chart, or focus it and press arrow keys, to read values; drag to zoom.' }, foot);
    this.addTools(foot);
  }

  Chart.prototype.options = function () {
    var chart = this, panel = this.panel, names = [''], series = {};
    this.series.curves.forEach(function (curve, i) {
      var name = 'c' + i;
      names.push(name);
      series[name] = { color: darkened(curve.colour), strokePattern: dashes[curve.dash].length ? dashes[curve.dash] : null,
        strokeWidth: curve.kind === 'points' || curve.kind === 'error_bars' ? 0 : curve.width, stepPlot: curve.kind === 'steps',
        drawPoints: curve.kind !== 'steps' && curve.columns[0].length <= 400, pointSize: 3.5,
        drawPointCallback: function (g, label, context, x, y, colour, size) { mark(context, x, y, colour, size, curve.marker); } };
    });
    if (names.length === 1) names.push('nothing');
    function axis(description) {
      var options = { axisLabelFormatter: function (number) { return brief(number); } };
      if (description.ticks.length) {
        options.ticker = function (low, high) {
          return description.ticks.filter(function (tick) { return tick[0] >= low && tick[0] <= high; })
            .map(function (tick) { return { v: tick[0], label: safe(tick[1]) }; });
        };
      }
      return options;
    }
    var interaction = Object.assign({}, Dygraph.defaultInteractionModel);
    interaction.dblclick = function () { chart.reset(); };
    return { labels: names, series: series, customBars: true, fillAlpha: 0.18, connectSeparatedPoints: false,
      axes: { x: Object.assign(axis(panel.x), { valueFormatter: brief }), y: axis(panel.y) },
      xlabel: labelOf(panel.x), ylabel: labelOf(panel.y), dateWindow: this.home.dateWindow.slice(),
      valueRange: this.home.valueRange.slice(), gridLineColor: '#dde2e7', axisLineColor: '#555', axisLabelFontSize: 13,
      xLabelHeight: 26, yLabelWidth: 20, highlightCircleSize: 5, showRoller: false, legend: 'never', interactionModel: interaction,
      underlayCallback: function (context, area, g) { chart.underlay(context, area, g); } };
  };

  // Once every panel has its place: a chart is as wide as it is then, until that changes.
  Chart.prototype.draw = function () {
    var chart = this, rows = this.series.rows;
    var empty = [null, null, null];
    if (rows.length === 0) rows = this.home.dateWindow.map(function (x) { return [x, empty]; });
    this.graph = new Dygraph(this.plot, rows, this.options());
    this.listen();
    new ResizeObserver(function () { if (chart.plot.clientWidth > 0) chart.graph.resize(); }).observe(this.plot);
  };

  Chart.prototype.underlay = function (context, area, g) {
    var chart = this;
    context.save();
    context.beginPath();
    context.rect(area.x, area.y, area.w, area.h);
    context.clip();
    this.boxes.forEach(function (layer) {
      if (chart.hidden[layer.legend]) return;
      layer.columns[0].forEach(function (unused, i) {
        var left = g.toDomXCoord(layer.columns[0][i]), right = g.toDomXCoord(layer.columns[1][i]);
        var top = area.y, bottom = area.y + area.h;
        if (layer.kind === 'boxes') { top = g.toDomYCoord(layer.columns[3][i]); bottom = g.toDomYCoord(layer.columns[2][i]); }
        if (Math.abs(bottom - top) > 0.01) fillBox(context, layer, left, top, right - left, bottom - top);
      });
    });
    context.restore();
  };

  Chart.prototype.setHidden = function (legend, hidden) {
    var chart = this;
    this.hidden[legend] = hidden;
    this.series.curves.forEach(function (curve, i) {
      if (curve.legend === legend) chart.graph.setVisibility(i, !hidden);
    });
    this.graph.updateOptions({});
  };

  Chart.prototype.reset = function () {
    this.graph.updateOptions({ dateWindow: this.home.dateWindow.slice(), valueRange: this.home.valueRange.slice() });
  };

  Chart.prototype.zoom = function (factor) {
    var range = this.graph.xAxisRange(), middle = this.at === undefined ? (range[0] + range[1]) / 2 : this.at;
    if (middle < range[0] || middle > range[1]) middle = (range[0] + range[1]) / 2;
    var window = [middle - (middle - range[0]) * factor, middle + (range[1] - middle) * factor];
    if (window[0] <= this.home.dateWindow[0] && window[1] >= this.home.dateWindow[1]) this.reset();
    else this.graph.updateOptions({ dateWindow: window });
  };

  Chart.prototype.pan = function (share) {
    var range = this.graph.xAxisRange(), step = share * (range[1] - range[0]);
    this.graph.updateOptions({ dateWindow: [range[0] + step, range[1] + step] });
  };

  Chart.prototype.addTools = function (holder) {
    var chart = this, tools = make('div', { class: 'tools' }, holder);
    var about = this.panel.title ? ' (' + this.panel.title + ')' : '';
    [['Zoom in', function () { chart.zoom(0.5); }], ['Zoom out', function () { chart.zoom(2); }],
      ['Left', function () { chart.pan(-0.25); }], ['Right', function () { chart.pan(0.25); }],
      ['Show all', function () { chart.reset(); }]].forEach(function (tool) {
      make('button', { type: 'button', text: tool[0], 'aria-label': tool[0] + about }, tools).addEventListener('click', tool[1]);
    });
  };

  // What is known at the place nearest to x: of curves their values, of boxes their heights.
  Chart.prototype.values = function (x) {
    var chart = this, near = null, found = [];
    this.places().forEach(function (place) { if (near === null || Math.abs(place - x) < Math.abs(near - x)) near = place; });
    var row = this.series.rows[this.series.xs.indexOf(near)];
    this.series.curves.forEach(function (curve, i) {
      if (!row || chart.hidden[curve.legend] || row[i + 1][1] === null) return;
      var cell = row[i + 1], ends = cell[0] === cell[1] && cell[2] === cell[1] ? '' : ' [' + brief(cell[0]) + ', ' + brief(cell[2]) + ']';
      found.push((curve.legend ? curve.legend + ': ' : '') + brief(cell[1]) + ends);
    });
    this.boxes.forEach(function (layer) {
      if (chart.hidden[layer.legend]) return;
      layer.columns[0].forEach(function (left, i) {
        var height = layer.kind === 'boxes' ? layer.columns[3][i] - layer.columns[2][i] : null;
        if (near < left || near > layer.columns[1][i] || height === 0) return;
        found.push((layer.legend ? layer.legend + ': ' : '') + (height === null ? 'yes' : brief(height)));
      });
    });
    return { x: near, texts: found };
  };

  Chart.prototype.places = function () {
    if (!this.all) {
      var all = new Set(this.series.xs);
      this.boxes.forEach(function (layer) {
        layer.columns[0].forEach(function (left, i) { all.add(layer.places ? layer.places[i] : (left + layer.columns[1][i]) / 2); });
      });
      this.all = Array.from(all).sort(function (a, b) { return a - b; });
    }
    return this.all;
  };

  Chart.prototype.tell = function (x) {
    var values = this.values(x), readout = this.readout, axis = this.panel.x;
    if (values.x === null) return;
    this.at = values.x;
    var tick = axis.ticks.filter(function (one) { return one[0] === values.x; })[0];
    var name = (axis.symbol || axis.quantity).replace(/_/g, '');
    readout.textContent = '';
    make('span', { text: name + ' = ' + (tick ? tick[1] : brief(values.x)) }, readout);
    values.texts.forEach(function (text) { make('span', { text: text }, readout); });
    var place = this.graph.toDomXCoord(values.x), area = this.graph.getArea();
    this.cursor.hidden = place < area.x || place > area.x + area.w;
    this.cursor.style.left = place + 'px';
    this.cursor.style.top = area.y + 'px';
    this.cursor.style.height = area.h + 'px';
  };

  Chart.prototype.step = function (by) {
    var places = this.places(), at = places.indexOf(this.at);
    var next = at < 0 ? 0 : Math.min(places.length - 1, Math.max(0, at + by));
    this.tell(places[next]);
  };

  Chart.prototype.listen = function () {
    var chart = this;
    this.plot.addEventListener('mousemove', function (event) {
      chart.tell(chart.graph.toDataXCoord(event.clientX - chart.plot.getBoundingClientRect().left));
    });
    this.plot.addEventListener('mouseleave', function () { chart.cursor.hidden = true; });
    var keys = { ArrowLeft: function () { chart.step(-1); }, ArrowRight: function () { chart.step(1); },
      Home: function () { chart.step(-Infinity); }, End: function () { chart.step(Infinity); },
      '+': function () { chart.zoom(0.5); }, '-': function () { chart.zoom(2); }, 0: function () { chart.reset(); } };
    this.frame.addEventListener('keydown', function (event) {
      if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
      keys[event.key]();
      event.preventDefault();
    });
  };

  function addLegend(figure, charts, holder) {
    var known = {}, legend = make('div', { class: 'legend', role: 'group', 'aria-label': 'Shown' });
    figure.panels.forEach(function (panel) {
      panel.layers.forEach(function (layer) {
        if (!layer.legend || known[layer.legend]) return;
        known[layer.legend] = true;
        var button = make('button', { type: 'button', 'aria-pressed': 'true' }, legend);
        button.appendChild(sample(layer));
        button.appendChild(document.createTextNode(layer.legend));
        button.addEventListener('click', function () {
          var hide = button.getAttribute('aria-pressed') === 'true';
          button.setAttribute('aria-pressed', String(!hide));
          charts.forEach(function (chart) { chart.setHidden(layer.legend, hide); });
        });
      });
    });
    if (legend.children.length) holder.parentNode.insertBefore(legend, holder);
  }

  function addCharts(holder) {
    var figure = JSON.parse(document.getElementById('data-' + holder.dataset.figure).textContent);
    var charts = figure.panels.map(function (panel) { return new Chart(panel, figure, holder); });
    addLegend(figure, charts, holder);
    charts.forEach(function (chart) { chart.draw(); });
  }

  // ---- tables

  function keyOf(row, column) {
    var text = row.cells[column].textContent.trim(), number = parseFloat(text);
    return { text: text, number: isNaN(number) ? null : number };
  }

  function compare(a, b) {
    if (a.number !== null && b.number !== null) return a.number - b.number;
    if (a.number !== null || b.number !== null) return a.number === null ? 1 : -1;
    return a.text < b.text ? -1 : a.text > b.text ? 1 : 0;
  }

  function sort(table, head, column) {
    var down = head.getAttribute('aria-sort') === 'ascending', body = table.tBodies[0];
    var rows = Array.from(body.rows).map(function (row, place) { return { row: row, place: place, key: keyOf(row, column) }; });
    rows.sort(function (a, b) { return (down ? compare(b.key, a.key) : compare(a.key, b.key)) || a.place - b.place; });
    rows.forEach(function (entry) { body.appendChild(entry.row); });
    Array.from(head.parentNode.cells).forEach(function (cell) { cell.removeAttribute('aria-sort'); });
    head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
  }

  function addSorting(table) {
    Array.from(table.tHead.rows[0].cells).forEach(function (head, column) {
      var button = make('button', { type: 'button' });
      while (head.firstChild) button.appendChild(head.firstChild);
      head.appendChild(button);
      button.addEventListener('click', function () { sort(table, head, column); });
    });
  }

  document.querySelectorAll('table.sortable').forEach(addSorting);
  if (typeof Dygraph === 'undefined') return;
  // Its legend sets a style attribute, which the page's policy forbids; the readout says the same.
  Dygraph.PLUGINS = Dygraph.PLUGINS.filter(function (plugin) { return plugin !== Dygraph.Plugins.Legend; });
  document.documentElement.classList.add('live');
  document.querySelectorAll('.charts').forEach(addCharts);
}());
