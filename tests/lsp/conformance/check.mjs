// Whether recorded messages are of the protocol's types: each becomes a literal of the type that npm's
// vscode-languageserver-protocol gives its method, and the TypeScript compiler says what does not fit, members too
// many among it. Usage: node check.mjs RECORDING.json, a list of [direction, message]; `in` is from the server.
import fs from 'node:fs';
import path from 'node:path';
import ts from 'typescript';
import * as protocol from 'vscode-languageserver-protocol';

const here = import.meta.dirname;

/** The name under which the library exports each method. */
function namesOfMethods() {
  const names = new Map();
  for (const [name, value] of Object.entries(protocol))
    if (typeof value === 'object' && value !== null && typeof value.method === 'string' && 'type' in value)
      names.set(value.method, name);
  return names;
}

const kHead = `
import * as p from 'vscode-languageserver-protocol';
type ParamsOf<T> = T extends p.ProtocolRequestType<infer P, any, any, any, any> ? P
  : T extends p.ProtocolRequestType0<any, any, any, any> ? null
  : T extends p.ProtocolNotificationType<infer P, any> ? P
  : T extends p.ProtocolNotificationType0<any> ? null : never;
type Sent<R> = R extends void ? null : R;  // no result at all is null in JSON
type ResultOf<T> = T extends p.ProtocolRequestType<any, infer R, any, any, any> ? Sent<R>
  : T extends p.ProtocolRequestType0<infer R, any, any, any> ? Sent<R> : never;
type ProgressValue = p.WorkDoneProgressBegin | p.WorkDoneProgressReport | p.WorkDoneProgressEnd;
function fits<T>(_: T) {}
`;

/** A line of TypeScript for each distinct message of the server, with its origin. */
function linesFor(recording, names) {
  const asked = new Map();
  const lines = [];
  const unknown = new Set();
  const add = (method, part, value) => {
    const name = names.get(method);
    if (name) lines.push({ method, text: `fits<${part}<typeof p.${name}.type>>(${JSON.stringify(value)});` });
    else if (!method.startsWith('$/') && !method.startsWith('proskill/')) unknown.add(method);
  };
  for (const [direction, message] of recording) {
    if (direction === 'out' && 'method' in message && 'id' in message) asked.set(message.id, message.method);
    if (direction !== 'in') continue;
    if ('method' in message) add(message.method, 'ParamsOf', message.params ?? null);
    else if ('result' in message && asked.has(message.id)) add(asked.get(message.id), 'ResultOf', message.result);
    if (message.method === '$/logTrace') lines.push({ method: message.method, text: `fits<p.LogTraceParams>(${JSON.stringify(message.params)});` });
    if (message.method === '$/progress' && 'kind' in message.params.value)
      lines.push({ method: message.method, text: `fits<ProgressValue>(${JSON.stringify(message.params.value)});` });
  }
  return { lines: [...new Map(lines.map((line) => [line.text, line])).values()], unknown };
}

function diagnosticsOf(source) {
  const file = path.join(here, 'messages.ts');
  const options = { strict: true, noEmit: true, skipLibCheck: true, target: ts.ScriptTarget.ES2022,
                    module: ts.ModuleKind.NodeNext, moduleResolution: ts.ModuleResolutionKind.NodeNext, types: ['node'],
                    typeRoots: [path.join(here, 'node_modules', '@types')] };
  const host = ts.createCompilerHost(options);
  const { readFile, fileExists, getSourceFile } = host;
  host.readFile = (name) => (name === file ? source : readFile(name));
  host.fileExists = (name) => name === file || fileExists(name);
  host.getSourceFile = (name, version, ...more) =>
    name === file ? ts.createSourceFile(name, source, version) : getSourceFile(name, version, ...more);
  return ts.getPreEmitDiagnostics(ts.createProgram([file], options, host));
}

const recording = JSON.parse(fs.readFileSync(process.argv[2], 'utf8'));
const { lines, unknown } = linesFor(recording, namesOfMethods());
const first = kHead.split('\n').length - 1;
const complaints = diagnosticsOf(kHead + lines.map((line) => line.text).join('\n') + '\n');
for (const method of unknown) console.log(`${method}: the protocol has no such method`);
for (const each of complaints) {
  const line = each.file && ts.getLineAndCharacterOfPosition(each.file, each.start).line - first;
  console.log(`${lines[line]?.method ?? 'messages.ts'}: ${ts.flattenDiagnosticMessageText(each.messageText, '\n  ')}`);
  if (lines[line]) console.log(`  ${lines[line].text.slice(0, 600)}`);
}
const methods = [...new Set(lines.map((line) => line.method))].sort();
console.log(`${lines.length} messages of ${methods.length} methods: ${methods.join(', ')}`);
process.exit(complaints.length + unknown.size > 0 ? 1 : 0);
