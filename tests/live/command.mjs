#!/usr/bin/env -S node --no-warnings
// command PROGRAM: runs a program for wasm32-wasi in Node.js.

import { readFileSync } from 'node:fs';
import { WASI } from 'node:wasi';

const wasi = new WASI({ version: 'preview1', args: process.argv.slice(2) });
const fail = () => { throw new Error('the program has thrown an exception'); };
const module = new WebAssembly.Module(readFileSync(process.argv[2]));
process.exitCode = wasi.start(new WebAssembly.Instance(module, { ...wasi.getImportObject(), page: { fail } }));
