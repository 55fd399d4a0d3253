// A worker of the page: it simulates every n-th pair of realisations, or counts those that others have simulated. What it
// is told and tells has the number of the question to which it belongs; that of a former question is dropped.
(function () {
  'use strict';

  var betweenResults = 80;  // ms
  var parts = null, engine = null, question = null, isTold = false;
  var turn = new MessageChannel();  // to itself: a question that has come meanwhile is heard first

  function tell(message, moved) { self.postMessage(Object.assign({ id: question.id }, message), moved || []); }

  // What is wrong with an experiment ends its instance.
  function attempt(act) {
    try {
      act();
    } catch (problem) {
      engine = null;
      tell({ problem: problem.message });
    }
  }

  function simulate() {
    var all = question.facts.realisations;
    while (question.next < all && engine.wantsMore()) {
      engine.start(question.next);
      question.next += 2 * question.workers;
    }
    if (engine.isIdle()) return;
    var done = engine.work();
    if (done) tell({ done: done }, [done.buffer]);
    turn.port2.postMessage(question.id);
  }

  function showResult() {
    isTold = false;
    if (engine) attempt(function () { tell({ result: engine.result() }); });
  }

  turn.port1.onmessage = function (event) {
    if (engine && question.id === event.data) attempt(simulate);
  };

  self.onmessage = function (event) {
    var message = event.data;
    if (message.parts) parts = message.parts;
    if (message.text) {
      question = { id: message.id, workers: message.workers, next: 2 * message.place };
      attempt(function () {
        if (!engine) engine = new engines.Engine(parts);
        question.facts = engine.begin(message.text);
        tell({ facts: question.facts, counts: message.counts });
        if (!message.counts) simulate();
      });
    }
    if (!engine || !question || question.id !== message.id) return;
    if (message.count) {
      attempt(function () { engine.count(message.count); });
      if (!isTold) {
        isTold = true;
        setTimeout(showResult, betweenResults);
      }
    }
    if ('play' in message) attempt(function () { tell({ shown: engine.motion(message.play) }); });
  };
}());
