// Appearance and spelling: hatching, markers, legend samples, numbers, labels.
var shapes = (function () {
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

  function brief(number) {
    if (number === null || !isFinite(number)) return 'none';
    return String(Number(number.toPrecision(4)));
  }

  function safe(text) {
    return text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');
  }

  // As HTML. The words A_h and Ω_h are symbols; other words may be names of files.
  function withSymbols(text) {
    return safe(text).replace(/(^| )(A|\u03a9)_h(?= |$)/g, '$1<i>$2<sub>h</sub></i>');
  }

  // As HTML, which is what dygraphs takes for labels.
  function labelOf(axis) {
    var symbol = axis.symbol && '<i>' + safe(axis.symbol).replace(/_([A-Za-z0-9]+)/g, '<sub>$1</sub>') + '</i>';
    return [safe(axis.quantity), symbol, axis.unit ? '[' + withSymbols(axis.unit) + ']' : ''].filter(Boolean).join(' ');
  }

  // Luminance of a colour in a grey print: ITU-R BT.601.
  function luma(colour) {
    var parts = [1, 3, 5].map(function (at) { return parseInt(colour.slice(at, at + 2), 16); });
    return 0.299 * parts[0] + 0.587 * parts[1] + 0.114 * parts[2];
  }

  // In a grey print a hatch must be visible: white on dark colours.
  function hatched(context, layer) {
    var lines = { 1: [1, -1], 2: [1, -1], 4: [1], 5: [-1], 6: [2], 7: [-2] }[layer.hatch] || [];
    if (lines.length === 0) return null;
    var size = layer.hatch === 2 ? 5 : 9;
    var tile = document.createElement('canvas');
    tile.width = size;
    tile.height = size * 2;
    var pen = tile.getContext('2d');
    pen.strokeStyle = luma(layer.colour) < 128 ? 'rgba(255, 255, 255, 0.75)' : 'rgba(0, 0, 0, 0.55)';
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

  function cross(context, x, y, arms) {
    arms.forEach(function (arm) {
      context.moveTo(x - arm[0], y - arm[1]);
      context.lineTo(x + arm[0], y + arm[1]);
    });
    context.stroke();
  }

  // Point types of gnuplot: 1 to 3 are made of strokes, 4 to 15 come in pairs, open and filled.
  function mark(context, x, y, colour, size, marker) {
    var sides = { 4: 4, 5: 4, 8: 3, 9: 3, 10: -3, 11: -3, 12: 4, 13: 4, 14: 5, 15: 5 }[marker];
    context.beginPath();
    context.strokeStyle = colour;
    context.fillStyle = colour;
    context.lineWidth = 1.3;
    if (marker <= 3) {
      if (marker !== 2) cross(context, x, y, [[size, 0], [0, size]]);
      if (marker !== 1) cross(context, x, y, [[size, size], [size, -size]]);
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

  // A pale colour is suitable for areas but hardly visible as a line.
  function darkened(colour) {
    return luma(colour) > 175 ? '#767676' : colour;
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
      if (layer.marker > 0 && layer.kind !== 'steps') mark(context, 15, 7, darkened(layer.colour), 4, layer.marker);
    }
    return canvas;
  }

  return { dashes: dashes, make: make, brief: brief, safe: safe, withSymbols: withSymbols, labelOf: labelOf,
    fillBox: fillBox, mark: mark, darkened: darkened, sample: sample };
}());
