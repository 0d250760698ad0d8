"use strict";

/* Grades the quizzes of a page as DREAMM does: a wrong answer says why that one is wrong. */

function checked(form) {
  return [...form.querySelectorAll("input:checked")].map((field) => field.dataset.value);
}

function wrongChoices(ask, chosen) {
  return ask.choices
    .map((choice, index) => ({ choice, isChosen: chosen.includes(String(index)) }))
    .filter(({ choice, isChosen }) => choice.right !== isChosen)
    .filter(({ isChosen }) => ask.type === "several" || isChosen)
    .map(({ choice }) => choice.why);
}

function wrongMarks(ask, marked) {
  const tooMany = marked.filter((id) => !ask.right.includes(id)).map((id) => ask.why[id] || ask.else);
  const missing = ask.right.filter((id) => !marked.includes(id)).map((id) => ask.missing[id] || ask.else);
  return [...new Set([...tooMany, ...missing])];
}

function wrongNumber(ask, form) {
  const given = form.querySelector("input").value;
  return Number(given) === ask.right && given !== "" ? [] : [ask.why[given] || ask.else];
}

function filledIn(form) {
  const places = {};
  const at = (place) => (places[place] = places[place] || { place, generic: 0, robots: [], tasks: [] });
  form.querySelectorAll("input").forEach((field) => {
    const [place, kind, name] = field.dataset.value.split("|");
    if (kind === "generic") {
      at(place).generic = Number(field.value || 0);
    } else if (field.checked) {
      at(place)[kind === "robot" ? "robots" : "tasks"].push(name);
    }
  });
  return Object.values(places);
}

function canonical(tokens) {
  return tokens
    .filter((at) => at.generic > 0 || at.robots.length > 0 || at.tasks.length > 0)
    .map((at) => [at.place, at.generic, [...at.robots].sort(), [...at.tasks].sort()])
    .map((at) => JSON.stringify(at))
    .sort()
    .join();
}

function wrongTokens(quiz, form) {
  const put = canonical(filledIn(form));
  if (put === canonical(quiz.right)) {
    return [];
  }
  const likely = quiz.ask.why.find((wrong) => canonical(wrong.tokens) === put);
  return [likely ? likely.why : quiz.ask.else];
}

function wrong(quiz, form) {
  switch (quiz.ask.type) {
    case "one":
      return checked(form).length === 0 ? ["Choose one."] : wrongChoices(quiz.ask, checked(form));
    case "several":
      return wrongChoices(quiz.ask, checked(form));
    case "mark":
      return wrongMarks(quiz.ask, checked(form));
    case "number":
      return wrongNumber(quiz.ask, form);
    default:
      return wrongTokens(quiz, form);
  }
}

document.querySelectorAll("form.quiz").forEach((form) => {
  const quiz = JSON.parse(form.querySelector("script").textContent);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const why = wrong(quiz, form);
    const output = form.querySelector("output");
    const explained = form.querySelector("a.explained");
    output.className = why.length === 0 ? "right" : "wrong";
    output.textContent = why.length === 0 ? "Right. " + quiz.solved : "Not yet.\n" + why.join("\n");
    if (explained) {
      explained.hidden = why.length === 0;
    }
  });
});
