package org.sami.lessons.course;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.lessons.course.QuizQuestion.Choice;
import org.sami.spn.vocabulary.Vocabulary;

/** Grades answers to quizzes. For each wrong answer it says why that one is wrong. */
public final class QuizGrader {
    private final Course course;
    private final Vocabulary vocabulary;

    /** A grader of the quizzes of a course. */
    public QuizGrader(Course course, Vocabulary vocabulary) {
        this.course = Objects.requireNonNull(course, "course");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /**
     * Grades an answer.
     *
     * @throws IllegalArgumentException if the answer has not the form of the question
     */
    public Grade grade(Lesson lesson, Step.Quiz quiz, Response response) {
        List<String> wrong = wrong(lesson, quiz, response);
        return wrong.isEmpty() ? new Grade(true, List.of(quiz.solved())) : new Grade(false, wrong);
    }

    /** The right answer to a quiz. */
    public Response right(Lesson lesson, Step.Quiz quiz) {
        QuizQuestion ask = quiz.ask();
        if (ask instanceof QuizQuestion.One one) {
            return new Response.Choice(rightOf(one.choices()).iterator().next());
        } else if (ask instanceof QuizQuestion.Several several) {
            return new Response.Choices(rightOf(several.choices()));
        } else if (ask instanceof QuizQuestion.Mark mark) {
            return new Response.Marks(new LinkedHashSet<>(mark.right()));
        } else if (ask instanceof QuizQuestion.Tokens tokens) {
            return new Response.Tokens(after(lesson, quiz, tokens));
        } else {
            return new Response.Amount(((QuizQuestion.Amount) ask).right());
        }
    }

    private static Set<Integer> rightOf(List<Choice> choices) {
        Set<Integer> right = new LinkedHashSet<>();
        for (int i = 0; i < choices.size(); i++) {
            if (choices.get(i).right()) {
                right.add(i);
            }
        }
        return right;
    }

    private List<String> wrong(Lesson lesson, Step.Quiz quiz, Response response) {
        QuizQuestion ask = quiz.ask();
        if (ask instanceof QuizQuestion.One one && response instanceof Response.Choice chosen) {
            Choice choice = one.choices().get(chosen.index());
            return choice.right() ? List.of() : List.of(choice.why());
        } else if (ask instanceof QuizQuestion.Several several && response instanceof Response.Choices chosen) {
            return wrongChoices(several.choices(), chosen.indices());
        } else if (ask instanceof QuizQuestion.Mark mark && response instanceof Response.Marks marked) {
            return wrongMarks(mark, marked.ids());
        } else if (ask instanceof QuizQuestion.Tokens tokens && response instanceof Response.Tokens put) {
            return wrongTokens(tokens, after(lesson, quiz, tokens), put.tokens());
        } else if (ask instanceof QuizQuestion.Amount amount && response instanceof Response.Amount given) {
            return given.number() == amount.right()
                    ? List.of()
                    : List.of(amount.why().getOrDefault(String.valueOf(given.number()), amount.otherwise()));
        }
        throw new IllegalArgumentException("the quiz \"" + quiz.id() + "\" is not answered by " + response);
    }

    private static List<String> wrongChoices(List<Choice> choices, Set<Integer> chosen) {
        List<String> wrong = new ArrayList<>();
        for (int i = 0; i < choices.size(); i++) {
            if (choices.get(i).right() != chosen.contains(i)) {
                wrong.add(choices.get(i).why());
            }
        }
        return wrong;
    }

    private static List<String> wrongMarks(QuizQuestion.Mark mark, Set<String> marked) {
        Set<String> wrong = new LinkedHashSet<>();
        marked.stream()
                .filter(id -> !mark.right().contains(id))
                .sorted()
                .forEach(id -> wrong.add(mark.why().getOrDefault(id, mark.otherwise())));
        mark.right().stream()
                .filter(id -> !marked.contains(id))
                .forEach(id -> wrong.add(mark.missing().getOrDefault(id, mark.otherwise())));
        return List.copyOf(wrong);
    }

    private static List<String> wrongTokens(QuizQuestion.Tokens ask, List<TokensAt> right, List<TokensAt> put) {
        if (set(right).equals(set(put))) {
            return List.of();
        }
        return List.of(ask.why().stream()
                .filter(wrong -> set(wrong.tokens()).equals(set(put)))
                .map(QuizQuestion.WrongTokens::why)
                .findFirst()
                .orElse(ask.otherwise()));
    }

    private static Set<TokensAt> set(List<TokensAt> tokens) {
        return tokens.stream()
                .filter(each -> !each.isEmpty())
                .map(TokensAt::sorted)
                .collect(Collectors.toSet());
    }

    private List<TokensAt> after(Lesson lesson, Step.Quiz quiz, QuizQuestion.Tokens ask) {
        String reference = quiz.picture()
                .orElseThrow(() -> new IllegalArgumentException("the quiz \"" + quiz.id() + "\" has no picture"))
                .plan();
        return TokensAfter.of(
                course.project(lesson.id(), reference).orElseThrow(),
                vocabulary,
                course.plan(lesson.id(), reference).orElseThrow(),
                ask.testCase(),
                ask.steps());
    }
}
