// The bytes of the module, in place of the package's load.mjs: the worker gets them from the page before it loads the package.
let bytes;

export function give(module) {
  bytes = module;
}

export { bytes as default };
