import { randomBytes } from 'node:crypto';
import * as vscode from 'vscode';

/** The panel's page. Script and style come from the extension; nothing is downloaded. */
export function page(webview: vscode.Webview, extension: vscode.Uri): string {
  const file = (name: string): vscode.Uri => webview.asWebviewUri(vscode.Uri.joinPath(extension, 'panel', name));
  const nonce = randomBytes(18).toString('base64');
  const policy = [
    "default-src 'none'", `script-src 'nonce-${nonce}'`, `style-src ${webview.cspSource}`,
    `img-src ${webview.cspSource} data: blob:`, "base-uri 'none'", "form-action 'none'",
  ].join('; ');
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${file('panel.css')}">
<title>ProSkill</title>
</head>
<body><div id="panel"></div><script nonce="${nonce}" src="${file('panel.js')}"></script></body>
</html>`;
}
