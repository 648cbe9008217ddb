// Khronos' validator finds neither errors nor warnings in files: node validate_glb.mjs FILES...
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

for (const file of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(file)));
  console.log(`${file}: ${issues.numErrors} errors, ${issues.numWarnings} warnings`);
  if (issues.numErrors + issues.numWarnings === 0) continue;
  console.log(issues.messages.map((m) => `  ${m.code} ${m.pointer}: ${m.message}`).join("\n"));
  process.exitCode = 1;
}
