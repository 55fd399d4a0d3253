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

  // Throws what the engine says is wrong; the instance must then be replaced.
  function Engine(module) {
    var engine = this;
    function fail(place, size) { throw new Error(engine.text(place, size)); }
    this.calls = new WebAssembly.Instance(module, { page: { fail: fail }, wasi_snapshot_preview1: system(module) }).exports;
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
