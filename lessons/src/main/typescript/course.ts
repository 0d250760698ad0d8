/*
 * Grades the quizzes of a page as DREAMM does: a wrong answer says why that one is wrong. It exports nothing, so that it becomes a script and not a
 * module: browsers load no modules from files.
 */

interface Choice {
  text: string;
  right: boolean;
  why: string;
}

interface TokensAt {
  place: string;
  generic: number;
  robots: string[];
  tasks: string[];
}

type Reasons = Record<string, string>;

interface Mark {
  type: 'mark';
  right: string[];
  why: Reasons;
  missing: Reasons;
  else: string;
}

interface Amount {
  type: 'number';
  right: number;
  why: Reasons;
  else: string;
}

interface Tokens {
  type: 'tokens';
  why: {tokens: TokensAt[]; why: string}[];
  else: string;
}

type Question = {type: 'one' | 'several'; choices: Choice[]} | Mark | Amount | Tokens;

/* What stands in a form as JSON; the program that writes the page names it QuizData. */
interface Quiz {
  ask: Question;
  solved: string;
  right: TokensAt[];
}

function part<E extends Element>(form: HTMLFormElement, selector: string): E {
  const found = form.querySelector<E>(selector);
  if (!found) {
    throw new Error('a quiz without ' + selector);
  }
  return found;
}

function valueOf(field: HTMLInputElement): string {
  return field.dataset.value ?? '';
}

function checked(form: HTMLFormElement): string[] {
  return [...form.querySelectorAll<HTMLInputElement>('input:checked')].map(valueOf);
}

function wrongChoices(choices: Choice[], several: boolean, chosen: string[]): string[] {
  return choices
    .map((choice, index) => ({choice, isChosen: chosen.includes(String(index))}))
    .filter(({choice, isChosen}) => choice.right !== isChosen)
    .filter(({isChosen}) => several || isChosen)
    .map(({choice}) => choice.why);
}

function wrongMarks(ask: Mark, marked: string[]): string[] {
  const tooMany = marked.filter((id) => !ask.right.includes(id)).map((id) => ask.why[id] || ask.else);
  const missing = ask.right.filter((id) => !marked.includes(id)).map((id) => ask.missing[id] || ask.else);
  return [...new Set([...tooMany, ...missing])];
}

function wrongNumber(ask: Amount, given: string): string[] {
  return Number(given) === ask.right && given !== '' ? [] : [ask.why[given] || ask.else];
}

function filledIn(form: HTMLFormElement): TokensAt[] {
  const places = new Map<string, TokensAt>();
  for (const field of form.querySelectorAll('input')) {
    const [place = '', kind, name = ''] = valueOf(field).split('|');
    const at = places.get(place) ?? {place, generic: 0, robots: [], tasks: []};
    places.set(place, at);
    if (kind === 'generic') {
      at.generic = Number(field.value || 0);
    } else if (field.checked) {
      at[kind === 'robot' ? 'robots' : 'tasks'].push(name);
    }
  }
  return [...places.values()];
}

function canonical(tokens: TokensAt[]): string {
  return tokens
    .filter((at) => at.generic > 0 || at.robots.length > 0 || at.tasks.length > 0)
    .map((at) => JSON.stringify([at.place, at.generic, [...at.robots].sort(), [...at.tasks].sort()]))
    .sort()
    .join();
}

function wrongTokens(ask: Tokens, right: TokensAt[], filled: TokensAt[]): string[] {
  const put = canonical(filled);
  if (put === canonical(right)) {
    return [];
  }
  return [ask.why.find((wrong) => canonical(wrong.tokens) === put)?.why ?? ask.else];
}

function wrong(quiz: Quiz, form: HTMLFormElement): string[] {
  const ask = quiz.ask;
  switch (ask.type) {
    case 'one':
      return checked(form).length === 0 ? ['Choose one.'] : wrongChoices(ask.choices, false, checked(form));
    case 'several':
      return wrongChoices(ask.choices, true, checked(form));
    case 'mark':
      return wrongMarks(ask, checked(form));
    case 'number':
      return wrongNumber(ask, part<HTMLInputElement>(form, 'input').value);
    case 'tokens':
      return wrongTokens(ask, quiz.right, filledIn(form));
  }
}

document.querySelectorAll<HTMLFormElement>('form.quiz').forEach((form) => {
  const quiz = JSON.parse(part(form, 'script').textContent ?? '') as Quiz;
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const why = wrong(quiz, form);
    const output = part(form, 'output');
    const explained = form.querySelector<HTMLAnchorElement>('a.explained');
    output.className = why.length === 0 ? 'right' : 'wrong';
    output.textContent = why.length === 0 ? 'Right. ' + quiz.solved : 'Not yet.\n' + why.join('\n');
    if (explained) {
      explained.hidden = why.length === 0;
    }
  });
});
