// Charts drawn by dygraphs, with zoom, readout and keyboard control. The panels of a figure are in the page as JSON.
var charts = (function () {
  'use strict';

  // A series with its intervals as bars with caps, for dygraphs.
  function plotBars(event) {
    var context = event.drawingContext, area = event.plotArea, cap = 4;
    context.save();
    context.strokeStyle = event.color;
    context.lineWidth = 1.5;
    context.beginPath();
    event.points.forEach(function (point) {
      var ends = [point.y_bottom, point.y_top].map(function (share) { return area.y + area.h * share; });
      if (!isFinite(ends[0]) || !isFinite(ends[1]) || ends[0] === ends[1]) return;
      context.moveTo(point.canvasx, ends[0]);
      context.lineTo(point.canvasx, ends[1]);
      ends.forEach(function (end) {
        context.moveTo(point.canvasx - cap, end);
        context.lineTo(point.canvasx + cap, end);
      });
    });
    context.stroke();
    context.restore();
    Dygraph.Plotters.linePlotter(event);
  }

  // Layers without an entry in the legend belong to the nearest layer of their colour that has one.
  function assign(panel) {
    panel.layers.forEach(function (layer, place) {
      var near = null;
      panel.layers.forEach(function (other, i) {
        if (!other.legend || other.colour !== layer.colour) return;
        if (near === null || Math.abs(i - place) < Math.abs(near - place)) near = i;
      });
      layer.owner = layer.legend || (near === null ? '' : panel.layers[near].legend);
    });
  }

  function Chart(panel, figure, parent) {
    assign(panel);
    this.panel = panel;
    this.hidden = {};
    this.series = series.of(panel);
    this.boxes = panel.layers.filter(function (layer) { return layer.kind === 'boxes' || layer.kind === 'spans'; });
    this.home = { dateWindow: series.xRange(panel), valueRange: series.yRange(panel) };
    var holder = shapes.make('div', { class: 'panel' }, parent);
    if (panel.title) shapes.make('h4', {}, holder).innerHTML = shapes.withSymbols(panel.title);
    this.frame = shapes.make('div', { class: 'frame', tabindex: '0', role: 'group', 'aria-roledescription': 'chart',
      'aria-label': (panel.title ? panel.title + ': ' : '') + panel.y.quantity + ' against ' + panel.x.quantity +
        '. Arrow keys move along it and read its values; plus and minus zoom, 0 shows all. The table below has the numbers.'
    }, holder);
    this.plot = shapes.make('div', { class: 'plot' }, this.frame);
    this.row = 0;
    if (panel.height > 1 && panel.strip) this.plot.style.height = 21 * panel.height + 'rem';
    this.cursor = shapes.make('div', { class: 'cursor', hidden: '' }, this.frame);
    var foot = shapes.make('div', { class: 'foot' }, holder);
    this.readout = shapes.make('output', { class: 'readout',
      text: 'To read values, point at the chart, or focus it and press the arrow keys. Drag to zoom.' }, foot);
    this.addTools(foot);
  }

  Chart.prototype.options = function () {
    var chart = this, panel = this.panel, names = [''], looks = {};
    this.series.curves.forEach(function (curve, i) {
      var name = 'c' + i;
      names.push(name);
      var dash = shapes.dashes[curve.dash];
      looks[name] = { color: shapes.darkened(curve.colour), strokePattern: dash.length ? dash : null,
        strokeWidth: curve.kind === 'points' || curve.kind === 'error_bars' ? 0 : curve.width,
        stepPlot: curve.kind === 'steps', connectSeparatedPoints: curve.kind === 'line', pointSize: 3.5,
        drawPoints: curve.marker > 0 && curve.kind !== 'steps' && curve.columns[0].length <= 400,
        drawPointCallback: function (g, label, context, x, y, colour, size) {
          shapes.mark(context, x, y, colour, size, curve.marker);
        } };
      if (chart.series.barred[i]) looks[name].plotter = plotBars;
    });
    if (names.length === 1) names.push('nothing');
    function axis(description) {
      var options = { axisLabelFormatter: function (number) { return shapes.brief(number); } };
      var letters = Math.max.apply(null, description.ticks.map(function (tick) { return tick[1].length; }));
      if (letters > 6) options.axisLabelWidth = 8 * letters;
      if (description.logarithmic) options.logscale = true;
      if (description.ticks.length) {
        options.ticker = function (low, high) {
          return description.ticks.filter(function (tick) { return tick[0] >= low && tick[0] <= high; })
            .map(function (tick) { return { v: tick[0], label: shapes.safe(tick[1]) }; });
        };
      }
      return options;
    }
    var interaction = Object.assign({}, Dygraph.defaultInteractionModel);
    interaction.dblclick = function () { chart.reset(); };
    return { labels: names, series: looks, customBars: true, fillAlpha: 0.18,
      axes: { x: Object.assign(axis(panel.x), { valueFormatter: shapes.brief, pixelsPerLabel: 45 }), y: axis(panel.y) },
      xlabel: shapes.labelOf(panel.x), ylabel: shapes.labelOf(panel.y), dateWindow: this.home.dateWindow.slice(),
      valueRange: this.home.valueRange.slice(), gridLineColor: '#dde2e7', axisLineColor: '#555', axisLabelFontSize: 13,
      xLabelHeight: 26, yLabelWidth: 20, highlightCircleSize: 5, showRoller: false, interactionModel: interaction,
      underlayCallback: function (context, area, g) { chart.underlay(context, area, g); } };
  };

  // Called when every panel has its place: a chart takes its width at that time.
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
    // toDomXCoord knows no logarithmic axis of time.
    function place(x) { return area.x + area.w * g.toPercentXCoord(x); }
    context.save();
    context.beginPath();
    context.rect(area.x, area.y, area.w, area.h);
    context.clip();
    this.boxes.forEach(function (layer) {
      if (chart.hidden[layer.owner]) return;
      layer.columns[0].forEach(function (unused, i) {
        var left = place(layer.columns[0][i]), right = place(layer.columns[1][i]);
        var top = area.y, bottom = area.y + area.h;
        if (layer.kind === 'boxes') {
          top = g.toDomYCoord(layer.columns[3][i]);
          bottom = g.toDomYCoord(layer.columns[2][i]);
        }
        if (Math.abs(bottom - top) > 0.01) shapes.fillBox(context, layer, left, top, right - left, bottom - top);
      });
    });
    context.restore();
  };

  Chart.prototype.setHidden = function (legend, hidden) {
    var chart = this;
    this.hidden[legend] = hidden;
    this.series.curves.forEach(function (curve, i) {
      if (curve.owner === legend) chart.graph.setVisibility(i, !hidden);
    });
    this.graph.updateOptions({});
  };

  Chart.prototype.reset = function () {
    this.graph.updateOptions({ dateWindow: this.home.dateWindow.slice(), valueRange: this.home.valueRange.slice() });
  };

  // Zooming and moving use lengths on the screen. On a logarithmic axis these are ratios.
  Chart.prototype.onScreen = function (x) { return this.panel.x.logarithmic ? Math.log(x) : x; };
  Chart.prototype.fromScreen = function (x) { return this.panel.x.logarithmic ? Math.exp(x) : x; };

  Chart.prototype.zoom = function (factor) {
    var range = this.graph.xAxisRange().map(this.onScreen, this);
    var middle = this.at === undefined ? (range[0] + range[1]) / 2 : this.onScreen(this.at);
    if (middle < range[0] || middle > range[1]) middle = (range[0] + range[1]) / 2;
    var window = [middle - (middle - range[0]) * factor, middle + (range[1] - middle) * factor].map(this.fromScreen, this);
    if (window[0] <= this.home.dateWindow[0] && window[1] >= this.home.dateWindow[1]) this.reset();
    else this.graph.updateOptions({ dateWindow: window });
  };

  Chart.prototype.pan = function (share) {
    var range = this.graph.xAxisRange().map(this.onScreen, this), step = share * (range[1] - range[0]);
    this.graph.updateOptions({ dateWindow: [range[0] + step, range[1] + step].map(this.fromScreen, this) });
  };

  Chart.prototype.addTools = function (holder) {
    var chart = this, tools = shapes.make('div', { class: 'tools' }, holder);
    var about = this.panel.title ? ' (' + this.panel.title + ')' : '';
    [['Zoom in', function () { chart.zoom(0.5); }], ['Zoom out', function () { chart.zoom(2); }],
      ['Left', function () { chart.pan(-0.25); }], ['Right', function () { chart.pan(0.25); }],
      ['Show all', function () { chart.reset(); }]].forEach(function (tool) {
      var button = shapes.make('button', { type: 'button', text: tool[0], 'aria-label': tool[0] + about }, tools);
      button.addEventListener('click', tool[1]);
    });
  };

  // Values at the place nearest to x: of curves their values, of boxes their heights.
  Chart.prototype.values = function (x) {
    var chart = this, near = null, found = [];
    this.places().forEach(function (place) { if (near === null || Math.abs(place - x) < Math.abs(near - x)) near = place; });
    var row = this.series.rows[this.series.xs.indexOf(near)];
    this.series.curves.forEach(function (curve, i) {
      if (!row || chart.hidden[curve.owner] || row[i + 1][1] === null || isNaN(row[i + 1][1])) return;
      var known = chart.series.ends[i][near];
      var ends = known ? ' [' + shapes.brief(known[0]) + ', ' + shapes.brief(known[1]) + ']' : '';
      found.push((curve.legend ? curve.legend + ': ' : '') + shapes.brief(row[i + 1][1]) + ends);
    });
    this.boxes.forEach(function (layer) {
      if (chart.hidden[layer.owner]) return;
      layer.columns[0].forEach(function (left, i) {
        var height = layer.kind === 'boxes' ? layer.columns[3][i] - layer.columns[2][i] : null;
        if (near < left || near > layer.columns[1][i] || height === 0) return;
        if (chart.panel.strip) {
          if (Math.floor(layer.columns[2][i]) !== chart.row) return;
          height /= chart.panel.strip;
        }
        found.push((layer.legend ? layer.legend + ': ' : '') + (height === null ? 'yes' : shapes.brief(height)));
      });
    });
    return { x: near, texts: found };
  };

  Chart.prototype.places = function () {
    if (!this.all) {
      var all = new Set(this.series.xs);
      this.boxes.forEach(function (layer) {
        layer.columns[0].forEach(function (left, i) { all.add((left + layer.columns[1][i]) / 2); });
      });
      this.all = Array.from(all).sort(function (a, b) { return a - b; });
    }
    return this.all;
  };

  Chart.prototype.tell = function (x) {
    var values = this.values(x), readout = this.readout, axis = this.panel.x;
    if (values.x === null) return;
    this.at = values.x;
    // The bars of a category stand side by side around its place.
    var tick = axis.ticks.reduce(function (best, one) {
      return best && Math.abs(best[0] - values.x) <= Math.abs(one[0] - values.x) ? best : one;
    }, null);
    var name = (axis.symbol || axis.quantity).replace(/_/g, '');
    readout.textContent = '';
    shapes.make('span', { text: name + ' = ' + (tick ? tick[1] : shapes.brief(values.x)) }, readout);
    if (this.panel.strip) {
      shapes.make('span', { text: (this.panel.y.symbol || this.panel.y.quantity).replace(/_/g, '') + ' = ' +
        this.panel.y.ticks[this.row][1] }, readout);
    }
    values.texts.forEach(function (text) { shapes.make('span', { text: text }, readout); });
    var place = this.graph.toDomXCoord(values.x), area = this.graph.getArea();
    this.cursor.hidden = place < area.x || place > area.x + area.w;
    this.cursor.style.left = place + 'px';
    this.cursor.style.top = area.y + 'px';
    this.cursor.style.height = area.h + 'px';
  };

  // Of strips one above the other, the readout tells one.
  Chart.prototype.turnTo = function (y) {
    this.row = Math.max(0, Math.min(this.panel.y.ticks.length - 1, Math.floor(y)));
  };

  Chart.prototype.step = function (by) {
    var places = this.places(), at = places.indexOf(this.at);
    var next = at < 0 && by < Infinity ? 0 : Math.min(places.length - 1, Math.max(0, at + by));
    this.tell(places[next]);
  };

  Chart.prototype.listen = function () {
    var chart = this;
    this.plot.addEventListener('mousemove', function (event) {
      var place = chart.plot.getBoundingClientRect();
      chart.turnTo(chart.graph.toDataYCoord(event.clientY - place.top));
      chart.tell(chart.graph.toDataXCoord(event.clientX - place.left));
    });
    this.plot.addEventListener('mouseleave', function () { chart.cursor.hidden = true; });
    var keys = { ArrowLeft: function () { chart.step(-1); }, ArrowRight: function () { chart.step(1); },
      Home: function () { chart.step(-Infinity); }, End: function () { chart.step(Infinity); },
      '+': function () { chart.zoom(0.5); }, '-': function () { chart.zoom(2); }, 0: function () { chart.reset(); } };
    if (this.panel.strip) {
      keys.ArrowUp = function () { chart.turnTo(chart.row + 1); chart.step(0); };
      keys.ArrowDown = function () { chart.turnTo(chart.row - 1); chart.step(0); };
    }
    this.frame.addEventListener('keydown', function (event) {
      if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
      keys[event.key]();
      event.preventDefault();
    });
  };

  function addLegend(figure, charts, holder) {
    var known = {}, legend = shapes.make('div', { class: 'legend', role: 'group', 'aria-label': 'Shown' });
    figure.panels.forEach(function (panel) {
      panel.layers.forEach(function (layer) {
        if (!layer.legend || known[layer.legend]) return;
        known[layer.legend] = true;
        var button = shapes.make('button', { type: 'button', 'aria-pressed': 'true' }, legend);
        button.appendChild(shapes.sample(layer));
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

  return { add: addCharts };
}());
