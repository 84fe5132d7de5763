// usage: node validate_gltf.cjs FILE…    The official glTF validator; prints every message, fails on errors and warnings.
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const deps = path.join(__dirname, '../../build/deps/node/node_modules/gltf-validator');
const validator = require(deps);

async function main(files) {
  let bad = 0;
  for (const file of files) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
      uri: path.basename(file),
      maxIssues: 50,
      externalResourceFunction: (uri) => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri))).then((b) => new Uint8Array(b)),
    });
    const { numErrors, numWarnings, messages } = report.issues;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings`);
    for (const message of messages) console.log(`  ${message.code} ${message.pointer ?? ''}: ${message.message}`);
    bad += numErrors + numWarnings;
  }
  return bad ? 1 : 0;
}

main(process.argv.slice(2)).then((status) => process.exit(status), (error) => {
  console.error(String(error));
  process.exit(1);
});
