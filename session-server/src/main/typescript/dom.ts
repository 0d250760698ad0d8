// Elements of the page. What comes from the session is put in as text, never as markup.

/** Attributes by name: `true` puts one without a value, `false` and nothing leave it out. Names with `on` are listeners. */
export type Attributes = {[name: string]: string | number | boolean | null | undefined | ((event: never) => void)} & {
  [Name in keyof HTMLElementEventMap as `on${Name}`]?: (event: HTMLElementEventMap[Name]) => void;
};

/** The elements of index.html that have an id. */
interface Elements {
  login: HTMLFormElement;
  'login-fault': HTMLElement;
  'login-name': HTMLInputElement;
  'login-key': HTMLInputElement;
  session: HTMLElement;
  strip: HTMLElement;
  theme: HTMLButtonElement;
  state: HTMLElement;
  stop: HTMLButtonElement;
  stopped: HTMLElement;
  'stopped-words': HTMLElement;
  release: HTMLButtonElement;
  map: HTMLElement;
  readings: HTMLElement;
  layer: HTMLSelectElement;
  legend: HTMLElement;
  viewer: HTMLElement;
  tabs: HTMLElement;
  panel: HTMLElement;
  notice: HTMLElement;
}

/** An element with attributes, listeners (`onclick`) and children; texts become text nodes. */
export function element<Tag extends keyof HTMLElementTagNameMap>(tag: Tag, attributes: Attributes = {}, ...children: (Node | string | null | undefined)[]): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') {
      made.addEventListener(name.slice(2), value as (event: Event) => void);
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

/** An element of index.html. */
export function byId<Id extends keyof Elements>(id: Id): Elements[Id] {
  return document.getElementById(id) as Elements[Id];
}

/** What ends a hold. */
const OVER = ['pointerup', 'pointerleave', 'pointercancel', 'blur'];

/** A button that acts only after it was held for a second, so that no touch by accident does it. */
export function hold(button: HTMLElement, action: () => void) {
  let timer = 0;
  const end = () => {
    clearTimeout(timer);
    button.classList.remove('held');
    OVER.forEach((over) => window.removeEventListener(over, end));
  };
  const begin = (event: Event) => {
    event.preventDefault();
    end();
    button.classList.add('held');
    OVER.forEach((over) => window.addEventListener(over, end)); // only meanwhile: lists make such buttons again and again
    timer = window.setTimeout(() => {
      end();
      if (button.isConnected) { // a button that was replaced meanwhile does nothing
        action();
      }
    }, 1000);
  };
  button.addEventListener('pointerdown', begin);
  OVER.forEach((over) => button.addEventListener(over, end));
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

/** Seconds in words, such as 12 s, 3 min, 2 h. */
export function duration(ms: number) {
  const seconds = Math.max(0, Math.round(ms / 1000));
  return seconds < 100 ? seconds + ' s' : seconds < 5400 ? Math.round(seconds / 60) + ' min' : Math.round(seconds / 3600) + ' h';
}
