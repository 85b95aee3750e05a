import { randomBytes } from 'node:crypto';
import { readFileSync } from 'node:fs';
import * as vscode from 'vscode';

/** The panel's page. It contains its script and style, since each file that a webview loads costs a tenth of a second; nothing is downloaded. */
export function page(extension: vscode.Uri): string {
  const file = (name: string): string => readFileSync(vscode.Uri.joinPath(extension, 'panel', name).fsPath, 'utf8');
  const nonce = randomBytes(18).toString('base64');
  const policy = [
    "default-src 'none'", `script-src 'nonce-${nonce}'`, `style-src 'nonce-${nonce}'`, 'img-src data: blob:', "base-uri 'none'", "form-action 'none'",
  ].join('; ');
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<style nonce="${nonce}">${file('panel.css')}</style>
<title>ProSkill</title>
</head>
<body><div id="panel"></div><script nonce="${nonce}">${file('panel.js')}</script></body>
</html>`;
}
