// The animation of a realisation: the block on its floor, its time history and its phase portrait.
var motions = (function () {
  'use strict';

  var speeds = [0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5], factors = [1, 2, 5, 10, 20, 50, 100];
  var contacts = ['at rest', 'sliding', 'rocking', 'rocking and sliding', 'overturned'];
  var shades = ['#e3e3e3', '#bfe0f5', '', '#f8e0a8', '#bdbdbd'];
  var ink = '#1a1a1a', pale = '#8a929b', accent = '#d55e00', blue = '#0072b2';

  // A tilt in radians: over psi of the edge about which the block turns, the left one if it is positive.
  function angleOf(motion, tilt) { return tilt * motion.shapes[tilt < 0 ? 1 : 0]; }

  // A motion with what follows from its numbers: angles in radians, slips in metres.
  function read(motion) {
    var most = Math.max.apply(null, motion.tilts.map(function (tilt) { return Math.abs(angleOf(motion, tilt)); }));
    var slips = motion.slips.map(function (slip) { return slip * motion.unit; });
    return Object.assign(motion, { mostTilt: most, slips: slips, slipEnds: ends(slips),
      mostBase: Math.max.apply(null, motion.bases.map(Math.abs)) });
  }

  function ends(column) {
    return column.reduce(function (found, number) {
      return [Math.min(found[0], number), Math.max(found[1], number)];
    }, [Infinity, -Infinity]);
  }

  // Values of a column at a fractional place.
  function between(column, place) {
    var below = Math.min(Math.floor(place), column.length - 1), above = Math.min(below + 1, column.length - 1);
    return column[below] + (place - below) * (column[above] - column[below]);
  }

  function placeOf(times, time) {
    var low = 0, high = times.length - 1;
    if (time >= times[high]) return high;
    while (high - low > 1) {
      var middle = (low + high) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle;
    }
    return low + Math.max(0, (time - times[low]) / (times[high] - times[low]));
  }

  // The first of these numbers that is at least x.
  function reaching(numbers, x) {
    for (var i = 0; i < numbers.length; ++i) if (numbers[i] >= x) return numbers[i];
    return numbers[numbers.length - 1];
  }

  // 1, 2 or 5 times a power of ten, at most x.
  function round(x) {
    var power = Math.pow(10, Math.floor(Math.log10(x)));
    return power * (x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1);
  }

  function metres(x) { return x >= 1 ? shapes.brief(x) + ' m' : shapes.brief(1000 * x) + ' mm'; }

  function choice(holder, label, options, start, use) {
    var list = shapes.make('select', {}, shapes.make('label', { text: label + ' ' }, holder));
    options.forEach(function (option) { shapes.make('option', { value: option[0], text: option[1] }, list); });
    list.value = String(start);
    list.addEventListener('change', function () { use(list.value); });
    return list;
  }

  function Player(holder) {
    var all = JSON.parse(document.getElementById('data-' + holder.dataset.motions).textContent);
    this.still = window.matchMedia('(prefers-reduced-motion: reduce)');
    this.place = 0;
    this.playing = false;
    this.build(holder, all);
    this.show(all);
    this.listen(holder);
  }

  // Shows the first of these motions from its beginning.
  Player.prototype.show = function (all) {
    this.all = all.map(read);
    this.choose(0);
  };

  Player.prototype.build = function (holder, all) {
    var player = this;
    this.stage = shapes.make('div', { class: 'stage', tabindex: '0', role: 'group', 'aria-roledescription': 'animation',
      'aria-label': 'Animation of the block. The space bar plays and pauses; ' +
        'the left and right arrows, Home and End move in time.'
    });
    this.bar = shapes.make('div', { class: 'controls' }, holder);
    holder.appendChild(this.stage);
    function canvas(parent, label) { return shapes.make('canvas', { role: 'img', 'aria-label': label }, parent); }
    this.block = canvas(this.stage, 'The block on its floor');
    this.history = canvas(this.stage, 'Tilt, slip and base acceleration against time');
    this.portrait = canvas(this.stage, 'Phase portrait: tilt rate against tilt');
    this.readout = shapes.make('output', { class: 'readout', 'aria-live': 'off' }, holder);
    if (all.length > 1) {
      choice(this.bar, 'Response', all.map(function (motion, i) { return [i, motion.name]; }), 0,
        function (value) { player.choose(Number(value)); });
    }
    this.button = shapes.make('button', { type: 'button', text: 'Play' }, this.bar);
    this.slider = shapes.make('input', { type: 'range', min: '0', step: '1', 'aria-label': 'Time' },
      shapes.make('label', { class: 'time', text: 'Time ' }, this.bar));
    this.speed = choice(this.bar, 'Speed', speeds.map(function (speed) {
      return [speed, speed + ' \u00d7 real time'];
    }), 1, function () { player.from = null; });
    this.factor = choice(this.bar, 'Tilt and slip', factors.map(function (factor) {
      return [factor, factor === 1 ? 'to scale' : factor + ' \u00d7 enlarged'];
    }), 1, function () { player.draw(); });
  };

  Player.prototype.choose = function (number) {
    var motion = this.motion = this.all[number], last = motion.times.length - 1;
    this.place = 0;
    this.from = null;
    this.slider.max = String(last);
    this.slider.value = '0';
    // A period of the excitation should last about a second, a tilt should be visible.
    var slow = motion.period > 0 ? reaching(speeds, 0.75 * motion.period) : 1;
    this.speed.value = String(Math.min(1, slow));
    this.factor.value = String(motion.mostTilt > 0 ? Math.max(1, round(Math.min(100, 0.06 / motion.mostTilt))) : 1);
    this.background = null;
    this.draw();
  };

  Player.prototype.listen = function (holder) {
    var player = this;
    this.button.addEventListener('click', function () { player.touched = true; player.play(!player.playing); });
    this.slider.addEventListener('input', function () {
      player.touched = true;
      player.go(Number(player.slider.value));
    });
    var keys = { ' ': function () { player.play(!player.playing); }, Home: function () { player.go(0); },
      ArrowLeft: function () { player.go(Math.ceil(player.place) - 1); },
      ArrowRight: function () { player.go(Math.floor(player.place) + 1); },
      End: function () { player.go(player.motion.times.length - 1); } };
    this.stage.addEventListener('keydown', function (event) {
      if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
      player.touched = true;
      keys[event.key]();
      event.preventDefault();
    });
    new ResizeObserver(function () { player.background = null; player.draw(); }).observe(this.stage);
    this.still.addEventListener('change', function () { if (player.still.matches) player.play(false); });
    // It starts by itself once it is seen, and pauses out of sight; never if the reader wants less motion.
    new IntersectionObserver(function (entries) {
      var seen = entries[entries.length - 1].isIntersecting;
      if (!seen && player.playing) { player.play(false); player.paused = true; }
      else if (seen && !player.still.matches && (player.paused || !player.touched)) player.play(true);
    }, { threshold: 0.6 }).observe(this.stage);
  };

  Player.prototype.go = function (place) {
    this.place = Math.min(this.motion.times.length - 1, Math.max(0, place));
    this.from = null;
    this.slider.value = String(Math.round(this.place));
    this.draw();
  };

  Player.prototype.play = function (on) {
    var player = this;
    this.paused = false;
    if (on === this.playing) return;
    this.playing = on;
    this.from = null;
    this.button.textContent = on ? 'Pause' : 'Play';
    if (on && this.place >= this.motion.times.length - 1) this.go(0);
    if (on) window.requestAnimationFrame(function (now) { player.tick(now); });
  };

  Player.prototype.tick = function (now) {
    var player = this, times = this.motion.times;
    if (!this.playing) return;
    if (this.from === null) this.from = { now: now, time: between(times, this.place) };
    var time = this.from.time + (now - this.from.now) / 1000 * Number(this.speed.value);
    this.place = placeOf(times, time);
    this.slider.value = String(Math.round(this.place));
    this.draw();
    if (time >= times[times.length - 1]) this.play(false);
    else window.requestAnimationFrame(function (next) { player.tick(next); });
  };

  Player.prototype.now = function () {
    var motion = this.motion, place = this.place;
    return { time: between(motion.times, place), tilt: between(motion.tilts, place), rate: between(motion.rates, place),
      slip: between(motion.slips, place), base: between(motion.bases, place),
      contact: motion.contacts[Math.floor(place)] };
  };

  // Time as it is shown: in periods of the excitation, or in seconds.
  Player.prototype.shown = function (time) { return this.motion.period > 0 ? time / this.motion.period : time; };

  // The context of a canvas, cleared, in CSS pixels.
  function cleared(canvas) {
    var ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    var pen = canvas.getContext('2d');
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
    pen.fillStyle = pen.strokeStyle = ink;
    return { pen: pen, width: width, height: height };
  }

  function line(pen, points, colour, width) {
    pen.beginPath();
    points.forEach(function (point) { pen.lineTo(point[0], point[1]); });
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }

  function arrow(pen, x, y, length, colour) {
    var tip = x + length, side = Math.sign(length) * Math.min(7, Math.abs(length));
    line(pen, [[x, y], [tip, y]], colour, 2.5);
    if (Math.abs(length) > 2) line(pen, [[tip - side, y - 4], [tip, y], [tip - side, y + 4]], colour, 2.5);
  }

  Player.prototype.draw = function () {
    if (this.stage.clientWidth === 0) return;
    var state = this.now();
    this.drawBlock(state);
    this.drawViews(state);
    this.tell(state);
  };

  Player.prototype.drawBlock = function (state) {
    var motion = this.motion, factor = Number(this.factor.value), sheet = cleared(this.block), pen = sheet.pen;
    var limit = Math.PI / 2, angle = Math.max(-limit, Math.min(limit, factor * angleOf(motion, state.tilt)));
    var most = Math.min(limit, factor * motion.mostTilt), reach = motion.extent[2] * Math.sin(most);
    var slips = [factor * motion.slipEnds[0], factor * motion.slipEnds[1]];
    var wide = motion.extent[1] - motion.extent[0], half = 0.5 * (motion.extent[0] + motion.extent[1]);
    var follows = slips[1] - slips[0] > 3 * wide;
    var room = wide + 2 * reach + (follows ? 0 : slips[1] - slips[0]) + 0.6 * wide;
    var tall = Math.hypot(motion.extent[2], wide);
    var scale = Math.min((sheet.width - 16) / room, (sheet.height - 78) / tall);
    var floor = sheet.height - 52, slip = factor * state.slip;
    var middle = follows ? slip : 0.5 * (slips[0] + slips[1]);
    function x(metre) { return sheet.width / 2 + scale * (metre - middle - half); }
    // The floor with marks, relative to which the block slips.
    line(pen, [[0, floor], [sheet.width, floor]], ink, 2);
    var mark = round(0.35 * sheet.width / scale), left = middle + half - 0.5 * sheet.width / scale;
    for (var at = Math.ceil(left / mark * 4) * mark / 4; x(at) < sheet.width; at += mark / 4) {
      line(pen, [[x(at), floor], [x(at) - 5, floor + 7]], pale, 1);
    }
    if (motion.wall !== undefined) {
      var side = motion.wall > half ? 1 : -1, face = x(motion.wall) + side, top = floor - 1.1 * scale * motion.extent[2];
      line(pen, [[face, floor], [face, top]], ink, 2);
      for (var height = floor - 10; height > top; height -= 14) {
        line(pen, [[face, height], [face + side * 6, height - 6]], pale, 1);
      }
    }
    // The block turns about its left edge if the tilt is positive, otherwise about its right edge.
    var pivot = slip + (angle < 0 ? motion.base : 0), own = angle < 0 ? -motion.base : 0;
    var cosine = Math.cos(angle), sine = Math.sin(angle);
    function point(along, up) {
      return [x(pivot + (own + along) * cosine - up * sine), floor - scale * ((own + along) * sine + up * cosine)];
    }
    motion.rectangles.forEach(function (part) {
      var outline = [[0, 2], [1, 2], [1, 3], [0, 3], [0, 2]].map(function (corner) {
        return point(part[corner[0]], part[corner[1]]);
      });
      pen.beginPath();
      outline.forEach(function (corner) { pen.lineTo(corner[0], corner[1]); });
      pen.fillStyle = '#dbe9f6';
      pen.fill();
      line(pen, outline, ink, 2);
    });
    // The base between the edges, where it is not the lower side of a single rectangle.
    var plain = motion.rectangles.length === 1 && motion.extent[0] === 0 && motion.extent[1] === motion.base;
    if (!plain) line(pen, [point(0, 0), point(motion.base, 0)], ink, 4);
    var centre = point(motion.centre[0], motion.centre[1]);
    pen.beginPath();
    pen.arc(centre[0], centre[1], 3, 0, 2 * Math.PI);
    pen.fillStyle = ink;
    pen.fill();
    // The acceleration of the base, a scale bar, the factor.
    var largest = 0.3 * sheet.width;
    if (motion.mostBase > 0) arrow(pen, sheet.width / 2, floor + 20, largest * state.base / motion.mostBase, accent);
    pen.fillStyle = ink;
    pen.fillText('floor acceleration ' + state.base.toFixed(2) + ' g', 8, sheet.height - 8);
    var bar = round(0.25 * sheet.width / scale), right = sheet.width - 10;
    line(pen, [[right - scale * bar, sheet.height - 8], [right, sheet.height - 8]], ink, 2);
    pen.textAlign = 'right';
    pen.fillText(metres(bar), right, sheet.height - 13);
    pen.fillText(factor === 1 ? 'to scale' : 'tilt and slip ' + factor + ' \u00d7 enlarged', right, 16);
    pen.textAlign = 'left';
    pen.fillText(contacts[state.contact], 8, 16);
  };

  // Axes and curves change with the motion and the size only; they are kept as pictures.
  Player.prototype.drawViews = function (state) {
    if (!this.background) this.background = [this.strips(), this.phases()];
    var time = this.shown(state.time);
    [[this.history, this.background[0]], [this.portrait, this.background[1]]].forEach(function (view, number) {
      var sheet = cleared(view[0]), kept = view[1];
      sheet.pen.drawImage(kept.picture, 0, 0, sheet.width, sheet.height);
      if (number === 0) {
        line(sheet.pen, [[kept.x(time), 2], [kept.x(time), sheet.height - 30]], accent, 1.5);
      } else {
        sheet.pen.beginPath();
        sheet.pen.arc(kept.x(state.tilt), kept.y(state.rate), 5, 0, 2 * Math.PI);
        sheet.pen.fillStyle = accent;
        sheet.pen.fill();
      }
    });
  };

  function kept(sheet, canvas, more) {
    var picture = document.createElement('canvas');
    picture.width = canvas.width;
    picture.height = canvas.height;
    picture.getContext('2d').drawImage(canvas, 0, 0);
    return Object.assign({ picture: picture }, more);
  }

  function scaleOf(range, low, high) {
    var margin = range[0] === range[1] ? 1 : 0.05 * (range[1] - range[0]);
    var from = range[0] - margin, to = range[1] + margin;
    return function (number) { return low + (high - low) * (number - from) / (to - from); };
  }

  // Tilt, slip and base acceleration against time, one below the other.
  Player.prototype.strips = function () {
    var player = this, motion = this.motion, sheet = cleared(this.history), pen = sheet.pen, left = 66;
    var times = motion.times.map(this.shown, this), span = [times[0], times[times.length - 1]];
    function x(time) { return left + (sheet.width - left - 8) * (time - span[0]) / (span[1] - span[0]); }
    var rows = [['tilt \u0398', motion.tilts, 2]];
    if (motion.slipEnds[0] < motion.slipEnds[1]) {
      rows.push(['slip [mm]', motion.slips.map(function (slip) { return 1000 * slip; }), 1]);
    }
    rows.push(['floor [g]', motion.bases, 0.8]);
    var whole = rows.reduce(function (sum, row) { return sum + row[2]; }, 0), top = 2, bottom = sheet.height - 30;
    motion.contacts.forEach(function (contact, i) {
      if (!shades[contact] || i + 1 === times.length) return;
      pen.fillStyle = shades[contact];
      pen.fillRect(x(times[i]), top, x(times[i + 1]) - x(times[i]) + 0.5, bottom - top);
    });
    rows.forEach(function (row) {
      var foot = top + (bottom - top) * row[2] / whole, range = ends(row[1]);
      whole -= row[2];
      var y = scaleOf(range, foot - 3, top + 3);
      if (range[0] < 0 && range[1] > 0) line(pen, [[left, y(0)], [sheet.width - 8, y(0)]], pale, 0.5);
      var curve = row[1].map(function (number, i) { return [x(times[i]), y(number)]; });
      line(pen, curve, row[1] === motion.bases ? pale : ink, 1.3);
      line(pen, [[left, foot], [sheet.width - 8, foot]], pale, 0.75);
      pen.fillStyle = ink;
      pen.fillText(row[0], 4, 0.5 * (top + foot) + 4);
      pen.font = '10px system-ui, "DejaVu Sans", sans-serif';
      pen.textAlign = 'right';
      if (foot - top > 34) {
        pen.fillText(String(Number(range[1].toPrecision(2))), left - 4, top + 10);
        pen.fillText(String(Number(range[0].toPrecision(2))), left - 4, foot - 3);
      }
      pen.textAlign = 'left';
      pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
      top = foot;
    });
    var step = round((span[1] - span[0]) / 4);
    pen.textAlign = 'center';
    for (var at = Math.ceil(span[0] / step - 1e-9) * step; at <= span[1] + 1e-9; at += step) {
      line(pen, [[x(at), bottom], [x(at), bottom + 4]], ink, 1);
      pen.fillText(String(Number(at.toPrecision(6))), Math.min(x(at), sheet.width - 16), bottom + 15);
    }
    var unit = motion.period > 0 ? 'periods of the excitation' : 's';
    pen.fillText('time [' + unit + ']', 0.5 * (left + sheet.width), bottom + 28);
    pen.textAlign = 'left';
    return kept(sheet, player.history, { x: x });
  };

  Player.prototype.phases = function () {
    var motion = this.motion, sheet = cleared(this.portrait), pen = sheet.pen;
    var x = scaleOf(ends(motion.tilts), 22, sheet.width - 8), y = scaleOf(ends(motion.rates), sheet.height - 22, 20);
    line(pen, [[22, y(0)], [sheet.width - 8, y(0)]], pale, 0.5);
    line(pen, [[x(0), 20], [x(0), sheet.height - 22]], pale, 0.5);
    line(pen, motion.tilts.map(function (tilt, i) { return [x(tilt), y(motion.rates[i])]; }), blue, 1);
    pen.fillText('tilt rate \u0398\u2032 = d\u0398/d\u03c4', 6, 14);
    pen.textAlign = 'center';
    pen.fillText('tilt \u0398 = \u03b8/\u03c8' + (motion.shapes[0] === motion.shapes[1] ? '' : ' of its side'), 0.5 * sheet.width, sheet.height - 6);
    pen.textAlign = 'left';
    return kept(sheet, this.portrait, { x: x, y: y });
  };

  Player.prototype.tell = function (state) {
    var degrees = 180 / Math.PI * angleOf(this.motion, state.tilt), readout = this.readout, time = this.shown(state.time);
    var seconds = state.time.toFixed(2) + ' s';
    var when = this.motion.period > 0 ? 'period ' + time.toFixed(2) + ' (' + seconds + ')' : seconds;
    readout.textContent = '';
    [when, 'tilt ' + state.tilt.toFixed(3) + ' \u03c8 = ' + degrees.toFixed(2) + '\u00b0',
      'slip ' + (1000 * state.slip).toFixed(1) + ' mm', 'floor ' + state.base.toFixed(2) + ' g',
      contacts[state.contact]].forEach(function (text) { shapes.make('span', { text: text }, readout); });
    this.slider.setAttribute('aria-valuetext', when);
  };

  function add(holder) {
    holder.parentNode.classList.add('animated');
    return new Player(holder);
  }

  return { add: add };
}());
