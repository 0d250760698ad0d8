package org.sami.crw.gui.decision;

import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.session.api.Judgement;
import org.sami.session.api.RefusedException;
import org.sami.spn.protocol.Answer;

/**
 * Gives the answer of a decision: as soon as it is judged, unless something is to be minded first, and after three seconds although it is not judged. On
 * the event thread.
 */
final class AnswerGiving {
    private static final long LONGEST_JUDGING_MS = 3000;

    private final DecisionActions actions;
    private final Consumer<DecisionView> given;
    private final Runnable changed;
    private boolean underWay;
    private boolean pressed;
    private long pressedMillis;

    /**
     * Nothing is given yet.
     *
     * @param given is called when an answer was taken, with its decision: another one may be shown by then
     * @param changed is called when something else is so
     */
    AnswerGiving(DecisionActions actions, Consumer<DecisionView> given, Runnable changed) {
        this.actions = actions;
        this.given = given;
        this.changed = changed;
    }

    /** Another decision is shown, or something else is filled in: earlier presses belong to another answer. */
    void forget() {
        pressed = false;
    }

    /** Why nothing can be given now; empty where something can. */
    Optional<String> whyNot() {
        return underWay ? Optional.of("an answer is under way") : Optional.empty();
    }

    /** Gives what is filled in, which fits its question. */
    void press(DecisionView view) {
        if (view.judged().isCurrent()) {
            give(view, view.editor().answer().orElseThrow());
        } else {
            pressed = true;
            pressedMillis = actions.nowMillis();
            view.judged().look();
        }
    }

    /**
     * Gives what was pressed before, if that may be now; to be called when it is judged, and a few times a second.
     *
     * @param fits whether what is filled in is an answer
     */
    void settle(DecisionView view, boolean fits) {
        boolean current = view.judged().isCurrent();
        if (pressed && (current || actions.nowMillis() - pressedMillis > LONGEST_JUDGING_MS)) {
            pressed = false;
            boolean minded = current && !view.judged().judgement().doubts().isEmpty();
            if (fits && !minded) {
                give(view, view.editor().answer().orElseThrow());
            }
        }
    }

    /** What is to be known of an answer that can be given; empty text where nothing is. */
    String first(Judgement judgement) {
        if (pressed) {
            return "It is looked at first, and given unless something is to be minded";
        }
        return judgement.doubts().isEmpty() ? "" : "Answer gives it all the same";
    }

    /** Gives an answer at once. */
    void give(DecisionView view, Answer answer) {
        underWay = true;
        actions.answer(view.decision().id(), answer).whenComplete((done, fault) -> {
            underWay = false;
            view.refused(words(fault));
            if (fault == null) {
                given.accept(view);
            }
            changed.run();
        });
    }

    /** Stops the timer after which autonomy would answer. */
    void stopTimer(DecisionView view) {
        actions.hold(view.decision().id()).whenComplete((done, fault) -> {
            view.refused(words(fault));
            changed.run();
        });
    }

    private static String words(@Nullable Throwable fault) {
        return fault == null ? "" : "▲ " + RefusedException.reason(fault);
    }
}
