#!/bin/sh
# glb.sh FILE.glb: the Khronos glTF validator. Needs node and the npm package gltf-validator: one that node finds, or
# one that npm can fetch into build/npm. Without them a line says that it is skipped.
set -eu
file=$1
cd "$(dirname "$0")/../.."
command -v node >/dev/null 2>&1 || { echo "skipped: no node, so no glTF validator"; exit 0; }
export NODE_PATH="$PWD/build/npm/node_modules${NODE_PATH:+:$NODE_PATH}"
found() { node -e 'require("gltf-validator")' 2>/dev/null; }
if ! found; then
    command -v npm >/dev/null 2>&1 && npm install --silent --no-audit --no-fund --prefix build/npm gltf-validator >/dev/null 2>&1 || true
    found || { echo "skipped: node is there, the npm package gltf-validator is not"; exit 0; }
fi
node -e '
const bytes = new Uint8Array(require("fs").readFileSync(process.argv[1]));
require("gltf-validator").validateBytes(bytes).then((report) => {
    const { numErrors, numWarnings, messages } = report.issues;
    for (const m of messages.filter((m) => m.severity < 2)) console.log(`${m.code} ${m.pointer || ""}: ${m.message}`);
    console.log(`${process.argv[1]}: ${numErrors} errors, ${numWarnings} warnings`);
    process.exit(numErrors === 0 ? 0 : 1);
});' "$file"
