package org.sami.dreamm.learn;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.sami.lessons.course.Grade;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.QuizGrader;
import org.sami.lessons.course.QuizQuestion;
import org.sami.lessons.course.Response;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.TokensAt;
import org.sami.spn.protocol.Token;

/**
 * One quiz as a learner has it before him: what is chosen so far, what is said of it, and the right answer once it is right or was asked for. The order of the choices is
 * drawn by a seed. Used by one thread.
 */
public final class QuizModel {
    private final Lesson lesson;
    private final Step.Quiz quiz;
    private final QuizGrader grader;
    private final List<Integer> order;
    private final Set<Integer> choices = new LinkedHashSet<>();
    private final Set<String> marks = new LinkedHashSet<>();
    private TokenDraft tokens;
    private String number = "";
    private Optional<Grade> grade = Optional.empty();
    private boolean revealed;

    /**
     * A quiz that is not answered yet.
     *
     * @param seed draws the order of the choices
     */
    public QuizModel(Lesson lesson, Step.Quiz quiz, QuizGrader grader, long seed) {
        this.lesson = Objects.requireNonNull(lesson, "lesson");
        this.quiz = Objects.requireNonNull(quiz, "quiz");
        this.grader = Objects.requireNonNull(grader, "grader");
        List<Integer> drawn = new ArrayList<>(
                IntStream.range(0, choicesOf(quiz.ask()).size()).boxed().toList());
        Collections.shuffle(drawn, new Random(seed));
        order = List.copyOf(drawn);
        tokens = begin();
    }

    private TokenDraft begin() {
        return new TokenDraft(quiz.picture().map(picture -> picture.tokens()).orElse(List.of()));
    }

    private static List<QuizQuestion.Choice> choicesOf(QuizQuestion ask) {
        if (ask instanceof QuizQuestion.One one) {
            return one.choices();
        }
        return ask instanceof QuizQuestion.Several several ? several.choices() : List.of();
    }

    /** The quiz. */
    public Step.Quiz quiz() {
        return quiz;
    }

    /** The lesson that asks it. */
    public Lesson lesson() {
        return lesson;
    }

    /** The indices of the choices in the order in which they are shown. */
    public List<Integer> order() {
        return order;
    }

    /** A choice by its index in the file. */
    public QuizQuestion.Choice choice(int index) {
        return choicesOf(quiz.ask()).get(index);
    }

    /** The indices of what is chosen. */
    public Set<Integer> chosen() {
        return Collections.unmodifiableSet(choices);
    }

    /** Chooses one; of several that can be chosen together, takes it back where it is chosen. */
    public void choose(int index) {
        if (isClosed()) {
            return;
        }
        boolean taken = choices.contains(index);
        if (quiz.ask() instanceof QuizQuestion.One) {
            choices.clear();
            choices.add(index);
        } else if (taken) {
            choices.remove(index);
        } else {
            choices.add(index);
        }
        again();
    }

    /** Ids of the marked elements. */
    public Set<String> marks() {
        return Collections.unmodifiableSet(marks);
    }

    /** Marks an element, or takes the mark back. */
    public void mark(String id) {
        if (!isClosed()) {
            if (!marks.remove(id)) {
                marks.add(id);
            }
            again();
        }
    }

    /** What stands where in the answer. */
    public TokenDraft tokens() {
        return tokens;
    }

    /** The tokens that can be put into places. */
    public List<Token> tokenKinds() {
        List<TokensAt> all =
                new ArrayList<>(quiz.picture().map(picture -> picture.tokens()).orElse(List.of()));
        if (quiz.ask() instanceof QuizQuestion.Tokens ask
                && grader.right(lesson, quiz) instanceof Response.Tokens right) {
            all.addAll(right.tokens());
            ask.why().forEach(wrong -> all.addAll(wrong.tokens()));
        }
        return TokenDraft.kinds(all);
    }

    /** Puts a token into a place. */
    public void put(String place, Token token) {
        if (!isClosed()) {
            tokens.put(place, token);
            again();
        }
    }

    /** Takes all tokens out of a place. */
    public void clear(String place) {
        if (!isClosed()) {
            tokens.clear(place);
            again();
        }
    }

    /** The number as it was typed. */
    public String number() {
        return number;
    }

    /** Notes the number that is typed. */
    public void setNumber(String text) {
        if (!isClosed() && !number.equals(text)) {
            number = text;
            again();
        }
    }

    private void again() {
        grade = Optional.empty();
    }

    /** Why the answer cannot be checked now, in a sentence; empty where it can. */
    public Optional<String> whyNotCheck() {
        if (isClosed()) {
            return Optional.of("it is answered");
        }
        if (grade.isPresent()) {
            return Optional.of("this answer was checked: change it first");
        }
        return response().isPresent() ? Optional.empty() : Optional.of(missing());
    }

    private String missing() {
        if (quiz.ask() instanceof QuizQuestion.One) {
            return "choose one first";
        } else if (quiz.ask() instanceof QuizQuestion.Several) {
            return "choose at least one first";
        } else if (quiz.ask() instanceof QuizQuestion.Mark) {
            return "mark at least one element of the net first";
        }
        return "type a whole number first";
    }

    private Optional<Response> response() {
        QuizQuestion ask = quiz.ask();
        if (ask instanceof QuizQuestion.One) {
            return choices.stream().findFirst().map(Response.Choice::new);
        } else if (ask instanceof QuizQuestion.Several) {
            return choices.isEmpty() ? Optional.empty() : Optional.of(new Response.Choices(choices));
        } else if (ask instanceof QuizQuestion.Mark) {
            return marks.isEmpty() ? Optional.empty() : Optional.of(new Response.Marks(marks));
        } else if (ask instanceof QuizQuestion.Tokens) {
            return Optional.of(new Response.Tokens(tokens.tokens()));
        }
        return number.strip().matches("-?\\d{1,9}")
                ? Optional.of(new Response.Amount(Integer.parseInt(number.strip())))
                : Optional.empty();
    }

    /**
     * Grades what is chosen.
     *
     * @throws IllegalStateException with {@link #whyNotCheck} if there is nothing to grade
     */
    public Grade check() {
        whyNotCheck().ifPresent(why -> {
            throw new IllegalStateException(why);
        });
        Grade given = grader.grade(lesson, quiz, response().orElseThrow());
        grade = Optional.of(given);
        return given;
    }

    /** What was said of the answer; empty while it is not checked, and after it was changed. */
    public Optional<Grade> grade() {
        return grade;
    }

    /** Whether the last answer was wrong, and another can be given. */
    public boolean isWrong() {
        return !revealed && grade.filter(given -> !given.right()).isPresent();
    }

    /** Whether the right answer is known to the learner: given, or shown. */
    public boolean isClosed() {
        return revealed || grade.filter(Grade::right).isPresent();
    }

    /** Whether the right answer was shown without being given. */
    public boolean isRevealed() {
        return revealed;
    }

    /** Shows the right answer in place of the learner's. */
    public void reveal() {
        show(grader.right(lesson, quiz));
        grade = Optional.of(new Grade(true, List.of(quiz.solved())));
        revealed = true;
    }

    private void show(Response right) {
        choices.clear();
        marks.clear();
        if (right instanceof Response.Choice choice) {
            choices.add(choice.index());
        } else if (right instanceof Response.Choices several) {
            choices.addAll(several.indices());
        } else if (right instanceof Response.Marks mark) {
            marks.addAll(mark.ids());
        } else if (right instanceof Response.Tokens put) {
            tokens = new TokenDraft(put.tokens());
        } else if (right instanceof Response.Amount amount) {
            number = Integer.toString(amount.number());
        }
    }

    /** Begins again: nothing is chosen. */
    public void restart() {
        choices.clear();
        marks.clear();
        number = "";
        tokens = begin();
        grade = Optional.empty();
        revealed = false;
    }
}
