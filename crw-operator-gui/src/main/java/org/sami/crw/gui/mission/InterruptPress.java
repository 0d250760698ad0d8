package org.sami.crw.gui.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.spn.protocol.Answer;

/**
 * Presses interrupts of one mission each, for the boats that are selected where one is for boats; what cannot be undone is pressed once it was confirmed.
 * Withdraws a press while it asks which boats it is for. On the event thread.
 */
final class InterruptPress {
    private final OperatorContext context;
    private final List<Runnable> listeners = new ArrayList<>();
    private Optional<Proposed> proposed = Optional.empty();

    /** The interrupt to confirm, and its boats. */
    record Proposed(InterruptChoice choice, List<String> boats) {}

    InterruptPress(OperatorContext context) {
        this.context = context;
    }

    /** Calls a listener when a confirmation is due, or no longer. */
    void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** Whom a press would be for, in words: {@code " for anna"}, or dots where it asks; empty text where it is for no boat. */
    String whom(InterruptChoice choice) {
        return words(choice, boats(choice));
    }

    private static String words(InterruptChoice choice, List<String> boats) {
        return !choice.asksForBoats() ? "" : boats.isEmpty() ? "…" : " for " + String.join(", ", boats);
    }

    /** The boats that a press would name. */
    List<String> boats(InterruptChoice choice) {
        return choice.asksForBoats() ? context.boats().boats() : List.of();
    }

    /** An interrupt with its mission, in words. */
    String title(InterruptChoice choice) {
        return choice.name() + " of " + context.titles().words(choice.mission());
    }

    /** Why an interrupt cannot be pressed now; empty where it can. */
    Optional<String> whyNot(InterruptChoice choice) {
        return context.whyNotAct()
                .or(() -> context.commands().whyLocked("interrupt-confirm"))
                .or(() -> choice.asking().isPresent()
                        ? Optional.of(context.say("it asks already which boats it is for: answer that, or withdraw it"))
                        : Optional.empty())
                .or(() -> choice.isEnabled() ? Optional.empty() : Optional.of(choice.whyNot()));
    }

    /** Whether a press can be withdrawn here, where it asks which boats it is for. */
    boolean canWithdraw() {
        return context.whyNotAct().isEmpty()
                && context.commands().whyLocked("interrupt-withdraw").isEmpty();
    }

    /** Presses it, or asks to confirm it. */
    void press(InterruptChoice choice) {
        if (choice.isFinal()) {
            propose(Optional.of(new Proposed(choice, boats(choice))));
        } else {
            send(choice, boats(choice));
        }
    }

    private void send(InterruptChoice choice, List<String> boats) {
        context.tell(
                context.session().press(choice.name(), choice.mission(), boats),
                "Pressed " + title(choice) + words(choice, boats));
    }

    private void propose(Optional<Proposed> next) {
        proposed = next;
        listeners.forEach(Runnable::run);
    }

    /** What is to be confirmed. */
    Optional<Proposed> proposed() {
        return proposed;
    }

    /** Presses what was confirmed. */
    void confirm() {
        proposed.ifPresent(now -> {
            propose(Optional.empty());
            send(now.choice(), now.boats());
        });
    }

    /** Presses nothing. */
    void leave() {
        propose(Optional.empty());
    }

    /** Leaves what is to be confirmed where it cannot be pressed any longer. */
    void look(List<InterruptChoice> choices) {
        boolean gone = proposed.filter(now -> choices.stream()
                        .noneMatch(choice -> choice.mission() == now.choice().mission()
                                && choice.name().equals(now.choice().name())
                                && whyNot(choice).isEmpty()))
                .isPresent();
        if (gone) {
            context.notices()
                    .refused(title(proposed.orElseThrow().choice()) + " was not pressed: it cannot be any longer");
            leave();
        }
    }

    /** Withdraws a press that asks which boats it is for. */
    void withdraw(InterruptChoice choice) {
        choice.asking()
                .ifPresent(decision -> context.tell(
                        context.session().answer(decision, new Answer.Rejected(), OperatorContext.OPERATOR),
                        "Withdrew " + title(choice) + ": nothing was done"));
    }

    /** The interrupt that was pressed last and asks which boats it is for. */
    Optional<InterruptChoice> asking() {
        return context.models().interrupts().snapshot().stream()
                .filter(choice -> choice.asking().isPresent())
                .max((a, b) -> Long.compare(order(a.asking()), order(b.asking())));
    }

    private static long order(OptionalLong decision) {
        return decision.orElse(0);
    }
}
