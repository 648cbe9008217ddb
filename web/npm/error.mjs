/** What can't be done: one line in `message`, `code` as in Python, and the first offending `element`, -1 for none. */
export class Error extends globalThis.Error {
  constructor(message, code, element = -1) {
    super(message);
    this.name = 'gvd.Error';
    this.code = code;
    this.element = element;
  }
}

export function refuse(message, element) {
  throw new Error(message, 'invalid_option', element);
}
