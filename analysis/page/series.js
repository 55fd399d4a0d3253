// Converts the numbers of a panel to the form that dygraphs needs.
var series = (function () {
  'use strict';

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
    if (axis.logarithmic) return [low / 1.15, high * 1.15];
    var margin = low === high ? 1 : 0.02 * (high - low);
    return [low - margin, high + margin];
  }

  var isCurve = { line: true, points: true, steps: true };

  // Columns of places and of values. Curves and intervals have one column of places, boxes have two.
  function places(layer) {
    var one = isCurve[layer.kind] || layer.kind === 'ribbon' || layer.kind === 'error_bars';
    return one ? 1 : 2;
  }

  // The interval of a curve: a ribbon or error bars of the same group.
  function intervalOf(panel, curve) {
    var found = panel.layers.filter(function (layer) {
      return (layer.kind === 'ribbon' || layer.kind === 'error_bars') && layer.group === curve.group;
    })[0];
    if (!found) return null;
    var columns = found.columns.slice(-2), at = {};
    found.columns[0].forEach(function (x, i) { at[x] = [columns[0][i], columns[1][i]]; });
    return { at: at, barred: found.kind === 'error_bars' };
  }

  // A step curve is constant between its own places, also at the places of other curves, from its first to its last.
  function hold(curve, place, rows) {
    var level = null, last = Math.max.apply(null, curve.columns[0]);
    Array.from(rows.keys()).sort(function (a, b) { return a - b; }).forEach(function (x) {
      var cell = rows.get(x)[place];
      if (cell[1] !== null) level = cell;
      else if (level !== null && x < last) rows.get(x)[place] = level;
    });
  }

  // A place at which a line is interrupted. Over null, at the places of other curves, it goes on.
  var gap = [NaN, NaN, NaN];

  // Curves with their intervals for dygraphs: rows of x and [low, y, high]. An unknown end is set to the value of the
  // curve. `ends` holds the intervals without this replacement; `barred`: whether they are bars, not a ribbon.
  function seriesOf(panel) {
    var curves = panel.layers.filter(function (layer) { return isCurve[layer.kind]; });
    var bars = panel.layers.filter(function (layer) {
      return layer.kind === 'error_bars' && !curves.some(function (curve) { return curve.group === layer.group; });
    });
    curves = curves.concat(bars);
    var rows = new Map(), ends = curves.map(function () { return {}; }), barred = [];
    curves.forEach(function (curve, place) {
      var interval = curve.kind === 'error_bars' ? null : intervalOf(panel, curve);
      barred.push(interval ? interval.barred : curve.kind === 'error_bars');
      curve.columns[0].forEach(function (x, i) {
        if (x === null) return;
        if (!rows.has(x)) rows.set(x, curves.map(function () { return [null, null, null]; }));
        var y = curve.columns[1][i];
        var known = curve.kind === 'error_bars' ? [curve.columns[2][i], curve.columns[3][i]] : interval && interval.at[x];
        if (y === null) {
          if (curve.kind === 'line') rows.get(x)[place] = gap;
          return;
        }
        if (known && (known[0] !== null || known[1] !== null)) ends[place][x] = known;
        else known = [y, y];
        rows.get(x)[place] = [known[0] === null ? y : known[0], y, known[1] === null ? y : known[1]];
      });
    });
    curves.forEach(function (curve, place) { if (curve.kind === 'steps') hold(curve, place, rows); });
    var xs = Array.from(rows.keys()).sort(function (a, b) { return a - b; });
    return { curves: curves, xs: xs, ends: ends, barred: barred, rows: xs.map(function (x) { return [x].concat(rows.get(x)); }) };
  }

  return {
    of: seriesOf,
    xRange: function (panel) {
      return extent(panel, panel.x, function (layer) { return layer.columns.slice(0, places(layer)); });
    },
    yRange: function (panel) {
      return extent(panel, panel.y, function (layer) { return layer.columns.slice(places(layer)); });
    }
  };
}());
