package org.sami.crw.console;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.MixedInitiative;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.protocol.Answer;

/** Commands about decisions and messages. */
final class OperatorCommands {
    /** How this operator is called to the others. */
    static final String NAME = "console";

    private final ConsoleContext context;
    private final AnswerText answers;

    OperatorCommands(ConsoleContext context) {
        this.context = context;
        answers = new AnswerText(context.vocabulary().types());
    }

    List<ConsoleCommand> all() {
        return List.of(
                ConsoleCommand.of(
                        "decisions", "Lists what is asked, the most urgent first, and how to answer.", this::decisions),
                ConsoleCommand.of(
                        "answer NUMBER ANSWER",
                        "Answers a decision; 'answer ANSWER' the first one.",
                        this::answer,
                        this::answerWords),
                ConsoleCommand.of(
                        "hold NUMBER",
                        "Stops autonomy's timer of a decision, which then waits for you.",
                        this::hold,
                        this::timed),
                ConsoleCommand.of("messages", "Lists messages that nobody acknowledged.", this::messages));
    }

    /** A decision in words, how it can be answered included. */
    static void describe(PendingDecision pending, long nowMillis, AnswerText answers, Consumer<String> out) {
        DecisionPresentation shown = pending.presentation();
        String rank = shown.priority().name().toLowerCase(Locale.ROOT);
        out.accept(
                "[" + shown.id() + "] " + shown.title() + where(pending) + ", " + rank + autonomy(pending, nowMillis));
        shown.description().forEach(line -> out.accept("    " + line));
        answers.form(shown).forEach(line -> out.accept("    " + line));
    }

    /** The plan that asks, and the place where the title does not say it. */
    private static String where(PendingDecision pending) {
        if (pending.plan().isEmpty()) {
            return "";
        }
        boolean placeIsSaid =
                pending.place().isEmpty() || pending.presentation().isNamedByItsPlace();
        return " (" + pending.plan() + (placeIsSaid ? "" : ", " + pending.place()) + ")";
    }

    /** When autonomy answers, what, and how that is stopped. */
    private static String autonomy(PendingDecision pending, long nowMillis) {
        MixedInitiative autonomy = pending.presentation().autonomy();
        if (autonomy.isHeld()) {
            return ", autonomy is stopped";
        }
        if (!autonomy.counts()) {
            return "";
        }
        long seconds = Math.round(autonomy.remainingMillis(nowMillis).orElse(0) / 1000.0);
        return autonomy.words().isEmpty()
                ? ", autonomy has no answer"
                : ", autonomy " + autonomy.phrase() + " in " + seconds + " s (hold "
                        + pending.decision().id() + " stops it)";
    }

    private List<PendingDecision> pending() {
        return context.models().decisions().pending();
    }

    private void decisions(Arguments arguments, Consumer<String> out) {
        arguments.end();
        if (pending().isEmpty()) {
            out.accept("nothing is asked now; questions of missions appear here");
        }
        long now = context.session().nowMillis();
        pending().forEach(decision -> describe(decision, now, answers, out));
    }

    private List<String> answerWords(List<String> words) {
        if (words.size() <= 1) {
            return pending().stream()
                    .map(one -> String.valueOf(one.decision().id()))
                    .toList();
        }
        return pending().stream()
                .filter(one -> String.valueOf(one.decision().id()).equals(words.get(0)))
                .findFirst()
                .map(one -> answers.completions(one.presentation()))
                .orElse(List.of());
    }

    private void answer(Arguments arguments, Consumer<String> out) {
        PendingDecision pending = chosen(arguments);
        long id = pending.decision().id();
        Answer answer = answers.read(pending.presentation(), arguments.rest());
        Optional<String> wrong = context.models().decisions().check(id, answer, context.vocabulary());
        if (wrong.isPresent()) {
            throw new ConsoleFault(wrong.get());
        }
        List<String> doubts = context.await(context.session().answerJudged(pending.decision(), answer, NAME));
        out.accept("[" + id + "] is answered");
        doubts.forEach(words -> out.accept("    mind: " + words));
    }

    private List<String> timed(List<String> words) {
        return pending().stream()
                .filter(one -> one.presentation().autonomy().counts())
                .map(one -> String.valueOf(one.decision().id()))
                .toList();
    }

    private void hold(Arguments arguments, Consumer<String> out) {
        long id = arguments.number("number");
        arguments.end();
        context.await(context.session().hold(id)); // the news says it
    }

    /** The decision that is named; where its number is left out, the first, if there is one. */
    private PendingDecision chosen(Arguments arguments) {
        List<PendingDecision> all = pending();
        if (all.isEmpty()) {
            throw new ConsoleFault("nothing is asked now");
        }
        Optional<PendingDecision> named = all.stream()
                .filter(one -> String.valueOf(one.decision().id()).equals(arguments.peek()))
                .findFirst();
        if (named.isPresent()) {
            arguments.next("number");
            return named.get();
        }
        if (all.size() > 1) {
            throw new ConsoleFault("no decision has the number '" + arguments.peek() + "'; there are "
                    + String.join(
                            ", ",
                            all.stream()
                                    .map(one -> String.valueOf(one.decision().id()))
                                    .toList()));
        }
        return all.get(0);
    }

    private void messages(Arguments arguments, Consumer<String> out) {
        arguments.end();
        List<MessageEntry> open = context.models().messages().snapshot().stream()
                .filter(entry -> !entry.acknowledged() && !entry.muted())
                .toList();
        if (open.isEmpty()) {
            out.accept("no message waits");
        }
        open.forEach(entry -> out.accept(entry.number() + "  "
                + Numbers.clock(entry.message().atMillis()) + "  "
                + entry.message().priority().name().toLowerCase(Locale.ROOT) + "  "
                + entry.message().text()));
    }
}
