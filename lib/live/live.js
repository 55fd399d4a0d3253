// The page: sliders, workers, bars, the motion.
(function () {
  'use strict';

  var sliders = [
    { key: 'width', label: 'Width of the block', unit: 'm', min: 0.1, max: 3, step: 0.01 },
    { key: 'height', label: 'Height', unit: 'm', min: 0.2, max: 8, step: 0.01 },
    { key: 'amplitude', label: 'Peak acceleration of the floor', unit: 'g', min: 0, max: 2, step: 0.01 },
    { key: 'frequency', label: 'Frequency', unit: 'Hz', min: 0.2, max: 10, step: 0.01 },
    { key: 'fixed', label: 'Static friction', unit: '', min: 0.02, max: 1.5, step: 0.01 },
    { key: 'kinetic', label: 'Kinetic friction', unit: '', min: 0.01, max: 1.5, step: 0.01 },
    { key: 'scatter', label: 'Standard deviation of the friction', unit: '', min: 0, max: 0.1, step: 0.005 },
    { key: 'realisations', label: 'Realisations', unit: '', min: 20, max: 2000, step: 20 }
  ];
  var kinds = [['harmonic', 'a sine that goes on'], ['pulse', 'one sine']];
  var presets = [
    ['The headline scene', { width: 1, height: 4, kind: 'harmonic', amplitude: 0.98, frequency: 3.01, fixed: 0.4, kinetic: 0.35,
      scatter: 0.03, realisations: 200 }],
    ['A bookcase', { width: 0.35, height: 1.9, kind: 'harmonic', amplitude: 0.55, frequency: 2.5, fixed: 0.25, kinetic: 0.2,
      scatter: 0.03, realisations: 200 }],
    ['A rack', { width: 1.1, height: 5, kind: 'harmonic', amplitude: 0.9, frequency: 1.5, fixed: 0.35, kinetic: 0.3,
      scatter: 0.03, realisations: 200 }],
    ['A statue on a pulse', { width: 0.6, height: 1.8, kind: 'pulse', amplitude: 0.8, frequency: 1.5, fixed: 0.35, kinetic: 0.3,
      scatter: 0.05, realisations: 1000 }]
  ];
  var make = shapes.make;

  function element(id) { return document.getElementById(id); }

  // The text of an experiment file. What a sine does at first is left out; a pulse is followed until the block rests.
  function experimentOf(values) {
    var experiment = { format: 'rocking.experiment/1', title: 'One block on a shaken floor',
      block: { width_m: values.width, height_m: values.height },
      excitation: { kind: values.kind, amplitude_g: values.amplitude, frequency_hz: values.frequency },
      friction: { static: values.fixed, kinetic: values.kinetic } };
    if (values.kind === 'pulse') experiment.excitation.shape = 'sine';
    else experiment.horizon = { transient_periods: 40, sampled_periods: 60 };
    if (values.scatter > 0) experiment.fluctuation = { friction: { sigma: values.scatter, correlation: 1 } };
    return JSON.stringify(Object.assign(experiment, { realisations: values.realisations, seed: '0x2012' }), null, 2) + '\n';
  }

  function Page(parts) {
    this.id = 0;
    this.result = null;
    this.chosen = null;  // name of a response mode
    this.turns = {};     // realisations that were shown, by response mode
    this.addWorkers(parts);
    this.addPresets(document.querySelector('.presets'));
    this.addSliders(document.querySelector('.sliders'));
    this.listen();
    this.take(presets[0]);
  }

  Page.prototype.addWorkers = function (parts) {
    var page = this, code = new Blob([element('worker').textContent], { type: 'text/javascript' });
    var address = URL.createObjectURL(code), number = Math.max(1, Math.min(4, navigator.hardwareConcurrency || 2));
    function add() {
      var worker = new Worker(address);
      worker.postMessage({ parts: parts });
      worker.onmessage = function (event) { if (event.data.id === page.id) page.hear(event.data); };
      return worker;
    }
    this.counting = add();
    this.simulating = [];
    while (this.simulating.length < number) this.simulating.push(add());
  };

  Page.prototype.addPresets = function (holder) {
    var page = this;
    this.presets = presets.map(function (preset) {
      var button = make('button', { type: 'button', 'aria-pressed': 'false', text: preset[0] }, holder);
      button.addEventListener('click', function () { page.take(preset); });
      return button;
    });
  };

  Page.prototype.addSliders = function (form) {
    var page = this, label = make('label', {}, form);
    make('span', { text: 'The floor moves as' }, label);
    this.kind = make('select', { name: 'kind' }, label);
    kinds.forEach(function (kind) { make('option', { value: kind[0], text: kind[1] }, page.kind); });
    this.kind.addEventListener('input', function () { page.ask(); });
    this.inputs = {};
    sliders.forEach(function (slider) {
      var holder = make('label', {}, form);
      make('span', { text: slider.label }, holder);
      var output = make('output', {}, holder);
      var input = make('input', { type: 'range', name: slider.key, min: slider.min, max: slider.max, step: slider.step }, holder);
      input.addEventListener('input', function () { page.ask(slider.key); });
      page.inputs[slider.key] = { input: input, output: output, unit: slider.unit };
    });
    form.addEventListener('submit', function (event) { event.preventDefault(); });
  };

  Page.prototype.listen = function () {
    var page = this;
    element('save').addEventListener('click', function () {
      var file = new Blob([page.text], { type: 'application/json' }), address = URL.createObjectURL(file);
      make('a', { href: address, download: 'live.json' }).click();
      URL.revokeObjectURL(address);
    });
    new ResizeObserver(function () { page.drawBars(); page.drawStrobe(); }).observe(element('main'));
  };

  Page.prototype.take = function (preset) {
    var page = this;
    Object.keys(this.inputs).forEach(function (key) { page.inputs[key].input.value = String(preset[1][key]); });
    this.kind.value = preset[1].kind;
    this.ask(null, preset);
  };

  // Begins with what the sliders say. Kinetic friction is at most static friction: the one that was not moved follows.
  Page.prototype.ask = function (moved, preset) {
    var page = this, values = { kind: this.kind.value };
    var fixed = this.inputs.fixed.input, kinetic = this.inputs.kinetic.input;
    if (Number(kinetic.value) > Number(fixed.value)) {
      if (moved === 'kinetic') fixed.value = kinetic.value;
      else kinetic.value = fixed.value;
    }
    Object.keys(this.inputs).forEach(function (key) {
      var entry = page.inputs[key];
      values[key] = Number(entry.input.value);
      entry.output.textContent = entry.input.value + (entry.unit && ' ' + entry.unit);
      entry.input.setAttribute('aria-valuetext', entry.output.textContent);
    });
    this.presets.forEach(function (button, i) { button.setAttribute('aria-pressed', String(presets[i] === preset)); });
    this.begin(experimentOf(values));
  };

  Page.prototype.begin = function (text) {
    var page = this, count = this.simulating.length;
    this.id += 1;
    this.text = text;
    this.asked = performance.now();
    this.began = null;
    this.facts = null;
    this.result = null;
    this.turns = {};
    element('problem').hidden = true;
    element('experiment').textContent = text;
    element('input-digest').textContent = element('result-digest').textContent = '\u2026';
    this.counting.postMessage({ id: this.id, text: text, counts: true });
    this.simulating.forEach(function (worker, place) {
      worker.postMessage({ id: page.id, text: text, workers: count, place: place });
    });
  };

  Page.prototype.hear = function (message) {
    if (message.problem) return this.showProblem(message.problem);
    if (message.done) this.counting.postMessage({ id: this.id, count: message.done }, [message.done.buffer]);
    if (message.facts && this.began === null) this.began = performance.now() - this.asked;  // ms
    if (message.facts && message.counts) {
      this.facts = message.facts;
      element('input-digest').textContent = message.facts.sha256;
    }
    if (message.result) this.show(message.result);
    if (message.shown) this.play(message.shown);
  };

  Page.prototype.showProblem = function (text) {
    element('problem').textContent = text;
    element('problem').hidden = false;
    element('answer').textContent = 'This is not an experiment.';
    element('progress').textContent = '';
    element('input-digest').textContent = element('result-digest').textContent = 'none';
  };

  Page.prototype.show = function (result) {
    this.result = result;
    this.took = performance.now() - this.asked;
    element('answer').textContent = result.answer.trim().split('\n').join('; ') + '.';
    element('level').textContent = result.level;
    element('progress').textContent = result.realisations + ' of ' + this.facts.realisations + ' realisations' +
      (result.digest ? ', in ' + (this.took / 1000).toFixed(1) + ' s' : ' \u2026');
    if (result.digest) element('result-digest').textContent = result.digest;
    this.listBars();
    if (result.digest && !(this.chosen in this.turns)) this.choose(this.mostLikely());
  };

  Page.prototype.mostLikely = function () {
    return this.result.modes.reduce(function (best, mode) { return mode.count > best.count ? mode : best; });
  };

  // The list is built again only where other response modes occur, so that a bar keeps the focus.
  Page.prototype.listBars = function () {
    var page = this, names = this.result.modes.map(function (mode) { return mode.name; });
    if (String(names) !== String(this.names)) {
      var list = document.querySelector('.bars');
      list.textContent = '';
      this.names = names;
      this.bars = this.result.modes.map(function (mode, place) {
        var button = make('button', { type: 'button' }, make('li', {}, list)), words = make('span', {}, button);
        make('b', { text: mode.name + ' ' }, words);
        words.appendChild(document.createTextNode(mode.meaning));
        button.addEventListener('click', function () { page.choose(page.result.modes[place]); });
        return { button: button, canvas: make('canvas', { 'aria-hidden': 'true', class: 'frame' }, button),
          text: make('span', { class: 'shown-text' }, button) };
      });
    }
    this.bars.forEach(function (bar, place) {
      var mode = page.result.modes[place];
      bar.text.textContent = mode.text + ', ' + mode.count + ' of ' + page.result.realisations;
      bar.button.setAttribute('aria-pressed', String(mode.name === page.chosen));
    });
    this.drawBars();
  };

  function sheetOf(canvas) {
    var ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    var pen = canvas.getContext('2d');
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    return { pen: pen, width: canvas.clientWidth, height: canvas.clientHeight };
  }

  function lookOf(mode) { return { colour: mode.colour, hatch: mode.hatch, opacity: 1 }; }

  Page.prototype.drawBars = function () {
    if (!this.result) return;
    this.result.modes.forEach(function (mode, place) {
      var sheet = sheetOf(this.bars[place].canvas), pen = sheet.pen, middle = sheet.height / 2;
      shapes.fillBox(pen, lookOf(mode), 0, 3, sheet.width * mode.estimate, sheet.height - 6);
      if (!mode.interval) return;
      var ends = mode.interval.map(function (end) { return Math.min(sheet.width - 1, Math.max(1, sheet.width * end)); });
      [[5, '#fff'], [2, '#1a1a1a']].forEach(function (stroke) {
        pen.beginPath();
        pen.moveTo(ends[0], middle);
        pen.lineTo(ends[1], middle);
        ends.forEach(function (end) { pen.moveTo(end, middle - 5); pen.lineTo(end, middle + 5); });
        pen.lineWidth = stroke[0];
        pen.strokeStyle = stroke[1];
        pen.stroke();
      });
    }, this);
  };

  // Shows a realisation of a response mode: the first one, then the next one.
  Page.prototype.choose = function (mode) {
    var turn = this.turns[mode.name] || 0;
    this.turns[mode.name] = turn + 1;
    this.chosen = mode.name;
    this.listBars();
    this.counting.postMessage({ id: this.id, play: mode.numbers[turn % mode.numbers.length] });
  };

  Page.prototype.play = function (shown) {
    this.shown = shown;
    if (this.player) {
      this.player.show([shown.motion]);
    } else {
      make('script', { type: 'application/json', id: 'data-motions', text: JSON.stringify([shown.motion]) }, document.body);
      this.player = motions.add(document.querySelector('.motions'));
    }
    element('heading-motion').textContent = 'One realisation: ' + shown.motion.name;
    this.drawStrobe();
  };

  Page.prototype.drawStrobe = function () {
    var shown = this.shown;
    if (!shown) return;
    var canvas = document.querySelector('.strobe canvas'), sheet = sheetOf(canvas), pen = sheet.pen;
    var mode = this.result && this.result.modes.filter(function (each) { return each.name === shown.mode; })[0];
    this.look = mode || this.look;
    var most = [0, 1].map(function (axis) {
      return shown.strobe.reduce(function (found, point) { return Math.max(found, Math.abs(point[axis])); }, 1e-9);
    });
    function x(tilt) { return sheet.width / 2 + (sheet.width / 2 - 14) * tilt / most[0]; }
    function y(rate) { return sheet.height / 2 - (sheet.height / 2 - 26) * rate / most[1]; }
    pen.strokeStyle = '#8a929b';
    pen.lineWidth = 0.5;
    pen.beginPath();
    pen.moveTo(8, y(0));
    pen.lineTo(sheet.width - 8, y(0));
    pen.moveTo(x(0), 20);
    pen.lineTo(x(0), sheet.height - 20);
    pen.stroke();
    var colour = this.look ? shapes.darkened(this.look.colour) : '#1a1a1a', look = this.look;
    shown.strobe.forEach(function (point, i) {
      var isSampled = i >= shown.transient;
      shapes.mark(pen, x(point[0]), y(point[1]), isSampled ? colour : '#c9ced4', isSampled ? 3.5 : 2, isSampled && look ? look.marker : 7);
    });
    pen.fillStyle = '#1a1a1a';
    pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
    pen.fillText('tilt rate \u0398\u2032, within \u00b1' + shapes.brief(most[1]), 6, 14);
    pen.textAlign = 'center';
    pen.fillText('tilt \u0398, within \u00b1' + shapes.brief(most[0]), sheet.width / 2, sheet.height - 6);
    pen.textAlign = 'left';
  };

  // A module is packed: base64 of gzip.
  function unpacked(id) {
    var bytes = Uint8Array.from(atob(element(id).textContent), function (letter) { return letter.charCodeAt(0); });
    var stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Response(stream).arrayBuffer();
  }

  if (typeof WebAssembly === 'undefined' || typeof DecompressionStream === 'undefined') return;
  Promise.all(['engine', 'fused', 'fused-relaxed'].map(unpacked)).then(function (modules) {
    return WebAssembly.compile(modules[0]).then(function (module) {
      document.querySelector('div.live').hidden = false;
      element('answer').textContent = '\u2026';
      window.live = new Page({ module: module, fused: modules[1], relaxed: modules[2] });
    });
  });
}());
