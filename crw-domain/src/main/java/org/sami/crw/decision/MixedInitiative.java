package org.sami.crw.decision;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.markup.MarkupReader;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;

/**
 * Whether, when and what autonomy answers (markup Mixed Initiative Trigger).
 *
 * @param trigger what the plan says
 * @param answer what autonomy would answer; empty where it has no sensible answer
 * @param words that answer in words; empty text where there is none
 * @param atMillis when it answers, on the session's clock; empty where it does not, or where the operator has stopped its timer
 */
public record MixedInitiative(Trigger trigger, Optional<Answer> answer, String words, OptionalLong atMillis) {
    private static final int MOST_NAMED = 3; // of boats

    /** When autonomy answers instead of the operator. */
    public enum Trigger {
        NEVER,
        IMMEDIATELY,
        TIMER
    }

    public MixedInitiative {
        Objects.requireNonNull(trigger, "trigger");
        Objects.requireNonNull(answer, "answer");
        Objects.requireNonNull(words, "words");
        Objects.requireNonNull(atMillis, "atMillis");
    }

    static MixedInitiative of(Decision decision, String words) {
        Trigger trigger = new MarkupReader(decision.markups())
                .constant("MixedInitiativeTrigger", "trigger", Trigger.class)
                .orElse(isOfDomain(decision) && decision.automatic().isPresent() ? Trigger.TIMER : Trigger.NEVER);
        return new MixedInitiative(trigger, decision.automatic(), words, decision.deadlineMillis());
    }

    /** Whether the domain asks, outside of any plan: it names an answer of autonomy only with its time. */
    private static boolean isOfDomain(Decision decision) {
        return decision.mission() == Ids.NONE;
    }

    /**
     * What autonomy does when its time comes, as a phrase: {@code chooses 5 boats}, {@code answers yes}; that it gives no answer where it has
     * none.
     */
    public String phrase() {
        if (answer.isEmpty()) {
            return "gives no answer";
        }
        if (answer.get() instanceof Answer.Proxies chosen
                && (chosen.proxies().isEmpty() || chosen.proxies().size() > MOST_NAMED)) {
            return "chooses "
                    + (chosen.proxies().isEmpty() ? "no boat" : chosen.proxies().size() + " boats");
        }
        boolean chooses = answer.get() instanceof Answer.Proxies || answer.get() instanceof Answer.Option;
        return (chooses ? "chooses " : answer.get() instanceof Answer.Fields ? "enters " : "answers ") + words;
    }

    /** Whether a timer runs that the operator can stop. */
    public boolean counts() {
        return atMillis.isPresent();
    }

    /** Whether the operator has stopped the timer: autonomy does not answer any longer. */
    public boolean isHeld() {
        return trigger == Trigger.TIMER && atMillis.isEmpty();
    }

    /** In how many milliseconds autonomy answers; empty where it does not. */
    public OptionalLong remainingMillis(long nowMillis) {
        return atMillis.isEmpty() ? atMillis : OptionalLong.of(Math.max(0, atMillis.getAsLong() - nowMillis));
    }
}
