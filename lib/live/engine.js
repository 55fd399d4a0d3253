// The engine in JavaScript: an instance of the module, with what it imports. For the workers of the page, and for Node.js.
var engines = (function () {
  'use strict';

  var notThere = 52;  // ENOSYS of WASI

  // A page has no files, arguments or environment: what asks for them is told that there are none.
  function system(module) {
    var calls = {};
    WebAssembly.Module.imports(module).forEach(function (entry) {
      if (entry.module !== 'wasi_snapshot_preview1') return;
      calls[entry.name] = function () { return notThere; };
    });
    calls.proc_exit = function (code) { throw new Error('the engine ended with code ' + code); };
    return calls;
  }

  function instanceOf(bytes) { return new WebAssembly.Instance(new WebAssembly.Module(bytes)).exports.fused; }

  // Three numbers whose product and sum need one rounding: digits cancel, are lost, or tie.
  function operands(i) {
    function number(k) { return Math.sin(i * 7.1 + k) * Math.pow(2, (i * (k + 3)) % 61 - 30); }
    var a = number(1), b = number(2);
    return [a, b, i % 3 === 0 ? -(a * b) : i % 3 === 1 ? -(a * b) * (1 + Math.pow(2, -(i % 53))) : number(4)];
  }

  // The fused multiply-add: that of relaxed SIMD where a browser has it and it gives the bits of the one in software, whose
  // proof is in fused.hpp. The standard allows a browser to round twice, but then always.
  function fusedOf(parts) {
    var software = instanceOf(parts.fused), relaxed = null;
    try {
      relaxed = instanceOf(parts.relaxed);
    } catch (unknown) {
      return software;
    }
    for (var i = 0; i < 3000; ++i) {
      var given = operands(i);
      if (!Object.is(software.apply(null, given), relaxed.apply(null, given))) return software;
    }
    return relaxed;
  }

  // `parts`: the compiled `module`, and the bytes of `fused` and `relaxed`. Throws what the engine says is wrong; the
  // instance must then be replaced.
  function Engine(parts) {
    var engine = this, module = parts.module;
    function fail(place, size) { throw new Error(engine.text(place, size)); }
    this.fused = parts.operation = parts.operation || fusedOf(parts);
    this.calls = new WebAssembly.Instance(module, { page: { fail: fail, fused: parts.operation },
      wasi_snapshot_preview1: system(module) }).exports;
    this.calls._initialize();
  }

  Engine.prototype.bytes = function (place, size) { return new Uint8Array(this.calls.memory.buffer, place, size); };
  Engine.prototype.text = function (place, size) { return new TextDecoder().decode(this.bytes(place, size)); };
  Engine.prototype.replied = function (size) { return this.text(this.calls.rocking_reply(), size); };

  Engine.prototype.give = function (bytes, take) {
    var place = this.calls.rocking_allocate(bytes.length);
    this.bytes(place, bytes.length).set(bytes);
    var result = take(place, bytes.length);
    this.calls.rocking_release(place);
    return result;
  };

  // The text of an experiment; returns its digest, all of its keys, its realisations and periods.
  Engine.prototype.begin = function (text) {
    return JSON.parse(this.replied(this.give(new TextEncoder().encode(text), this.calls.rocking_begin)));
  };
  Engine.prototype.wantsMore = function () { return this.calls.rocking_wants_more() !== 0; };
  Engine.prototype.isIdle = function () { return this.calls.rocking_is_idle() !== 0; };
  // Starts the realisations `first` and, unless there are fewer, `first` + 1; `first` is even.
  Engine.prototype.start = function (first) { this.calls.rocking_start(first); };
  // Works for a moment; the pairs of realisations that are done, as bytes for count(). Null: none.
  Engine.prototype.work = function () {
    var size = this.calls.rocking_work();
    return size === 0 ? null : this.bytes(this.calls.rocking_reply(), size).slice();
  };
  Engine.prototype.count = function (bytes) { this.give(bytes, this.calls.rocking_count); };
  Engine.prototype.result = function () { return JSON.parse(this.replied(this.calls.rocking_result())); };
  Engine.prototype.motion = function (number) {
    var size = this.calls.rocking_motion(number);
    return size === 0 ? null : JSON.parse(this.replied(size));
  };

  return { Engine: Engine };
}());
