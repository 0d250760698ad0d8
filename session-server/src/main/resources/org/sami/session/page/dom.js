// @ts-check
// Elements of the page. What comes from the session is put in as text, never as markup.

/**
 * An element with attributes, listeners (`onclick`) and children; texts become text nodes.
 *
 * @param {string} tag
 * @param {Record<string, any>} [attributes]
 * @param {...(Node | string | null | undefined)} children
 * @returns {HTMLElement}
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) {
      made.addEventListener(name.slice(2), value);
    } else if (value === true) {
      made.setAttribute(name, '');
    } else if (value !== false && value !== undefined && value !== null) {
      made.setAttribute(name, String(value));
    }
  }
  for (const child of children) {
    if (child !== null && child !== undefined) {
      made.append(child);
    }
  }
  return made;
}

/** @param {string} id @returns {any} */
export function byId(id) {
  return /** @type {any} */ (document.getElementById(id));
}

/**
 * A button that acts only after it was held for a second, so that no touch by accident does it.
 *
 * @param {HTMLElement} button
 * @param {() => void} action
 */
export function hold(button, action) {
  let timer = 0;
  const end = () => {
    clearTimeout(timer);
    button.classList.remove('held');
  };
  const begin = (/** @type {Event} */ event) => {
    event.preventDefault();
    end();
    button.classList.add('held');
    timer = window.setTimeout(() => {
      end();
      if (button.isConnected) { // a button that was replaced meanwhile does nothing
        action();
      }
    }, 1000);
  };
  button.addEventListener('pointerdown', begin);
  for (const over of ['pointerup', 'pointerleave', 'pointercancel', 'blur']) {
    button.addEventListener(over, end);
    window.addEventListener(over, end);
  }
  button.addEventListener('keydown', (event) => {
    if ((event.key === 'Enter' || event.key === ' ') && !event.repeat) {
      begin(event);
    }
  });
  button.addEventListener('keyup', end);
  button.addEventListener('contextmenu', (event) => event.preventDefault());
}

let pressed = false;
window.addEventListener('pointerdown', () => (pressed = true), true);
for (const over of ['pointerup', 'pointercancel', 'blur']) {
  window.addEventListener(over, () => window.setTimeout(() => (pressed = false), 50), true); // after the click that follows
}

/** Whether a pointer is down, so that nothing below it is to be replaced. */
export function isPressed() {
  return pressed;
}

/**
 * Seconds in words, such as 12 s, 3 min, 2 h.
 *
 * @param {number} ms
 */
export function duration(ms) {
  const seconds = Math.max(0, Math.round(ms / 1000));
  return seconds < 100 ? seconds + ' s' : seconds < 5400 ? Math.round(seconds / 60) + ' min' : Math.round(seconds / 3600) + ' h';
}
