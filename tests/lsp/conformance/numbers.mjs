// The protocol's numbers as C++: made from npm's vscode-languageserver-protocol.
// Usage: node numbers.mjs write|check
import fs from 'node:fs';
import path from 'node:path';
import * as protocol from 'vscode-languageserver-protocol';

const ROOT = path.resolve(import.meta.dirname, '../../..');
const MADE = '// Made by tests/lsp/conformance/numbers.mjs from npm\'s vscode-languageserver-protocol.\n';

/** The members of one of the library's enumerations, in the order of their values. */
function membersOf(name) {
  return Object.entries(protocol[name]).filter(([, value]) => typeof value === 'number').sort((a, b) => a[1] - b[1]);
}

function enumeration(name, members) {
  const lines = members.map(([member, value]) => `  ${member[0].toUpperCase()}${member.slice(1)} = ${value},\n`);
  return `enum class ${name} : int {\n${lines.join('')}};\n`;
}

/** Constants that only bound a range are never sent. */
const errorCodes = ['ErrorCodes', 'LSPErrorCodes'].flatMap(membersOf).filter(([member]) => /^[A-Z]/.test(member));

const files = {
  'rpc/error_codes.h': `${MADE}#pragma once

namespace proskill::rpc {

/// Error codes of JSON-RPC and of the language server protocol.
${enumeration('ErrorCode', errorCodes)}
} // namespace proskill::rpc
`,
  'lsp/protocol/numbers.h': `${MADE}#pragma once

/// The enumerations of the language server protocol that are sent as numbers.
namespace proskill::lsp::protocol {

${['CompletionItemKind', 'CompletionItemTag', 'DiagnosticSeverity', 'DiagnosticTag', 'DocumentHighlightKind', 'InlayHintKind',
    'InsertTextFormat', 'InsertTextMode', 'MessageType', 'SymbolKind', 'TextDocumentSyncKind'].map((name) => enumeration(name, membersOf(name))).join('\n')}
} // namespace proskill::lsp::protocol
`,
};

let outdated = 0;
for (const [name, text] of Object.entries(files)) {
  const file = path.join(ROOT, name);
  if (process.argv[2] === 'write') fs.writeFileSync(file, text);
  else if (fs.readFileSync(file, 'utf8') !== text) outdated += console.log(`${name} is not what numbers.mjs makes: run it with \`write\``) ?? 1;
}
process.exit(outdated ? 1 : 0);
