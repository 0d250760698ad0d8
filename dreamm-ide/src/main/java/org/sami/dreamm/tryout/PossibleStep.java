package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.stepping.Possible;
import org.sami.spn.stepping.StepText;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.EventType;

/**
 * One thing that can happen to the tried plan now.
 *
 * @param key what it is about: equal for the same thing at two moments
 * @param who who does it: Operator, Answer, News, Button, Time, Robot
 */
record PossibleStep(String key, String who, String what, What of) {
    /** What happens. */
    sealed interface What {
        /** The operator answers. */
        record Decide(Decision decision) implements What {}

        /** Robots or services answer an activation. */
        record Respond(Activation asked, EventType type) implements What {}

        /** Something arrives that nobody asked for. */
        record News(EventType type) implements What {}

        /** An interrupt is pressed. */
        record Press(InterruptButton button) implements What {}

        /** Time passes, until the next timer where one runs. */
        record Wait(long nextTimerMillis) implements What {}

        /** A robot joins, or is dropped. */
        record Robot(String name, boolean joins) implements What {}
    }

    PossibleStep {
        Objects.requireNonNull(key, "key");
        Objects.requireNonNull(who, "who");
        Objects.requireNonNull(what, "what");
        Objects.requireNonNull(of, "of");
    }

    /** All that can happen now: what waits for somebody first, then time, news and robots. */
    static List<PossibleStep> of(Stepper stepper) {
        List<PossibleStep> all = new ArrayList<>();
        Possible possible = stepper.possible();
        StepText words = stepper.words();
        for (Decision d : possible.decisions()) {
            String asking = stepper.eventAsking(d);
            all.add(new PossibleStep(
                    "decision-" + d.id(),
                    "Operator",
                    asked(d.prompt(), asking.isEmpty() ? "" : words.deciding(asking)),
                    new What.Decide(d)));
        }
        for (Possible.OpenActivation open : possible.activations()) {
            Activation asked = open.activation();
            for (EventType type : open.answers()) {
                all.add(new PossibleStep(
                        "answer-" + asked.id() + "-" + type.name(),
                        "Answer",
                        type.title() + " to " + words.asking(asked.event(), type.name()) + whom(asked),
                        new What.Respond(asked, type)));
            }
        }
        for (InterruptButton button : possible.interrupts()) {
            all.add(new PossibleStep(
                    "press-" + button.mission() + "-" + button.name(),
                    "Button",
                    button.name(),
                    new What.Press(button)));
        }
        long next = possible.nextDueMillis().isEmpty()
                ? -1
                : Math.max(0, possible.nextDueMillis().getAsLong() - stepper.nowMillis());
        all.add(new PossibleStep(
                "time", "Time", next < 0 ? "passes; no timer runs" : "passes; the next timer", new What.Wait(next)));
        for (EventType type : possible.news()) {
            all.add(new PossibleStep("news-" + type.name(), "News", type.title(), new What.News(type)));
        }
        List<String> known = stepper.view().proxies();
        String another = "robot-" + (known.size() + 1);
        all.add(new PossibleStep("join", "Robot", another + " joins", new What.Robot(another, true)));
        known.forEach(robot -> all.add(
                new PossibleStep("drop-" + robot, "Robot", robot + " is dropped", new What.Robot(robot, false))));
        return all;
    }

    /** A question with the event that asks it, unless the one names the other. */
    private static String asked(String prompt, String event) {
        String title = event.contains(" at ") ? event.substring(0, event.indexOf(" at ")) : event;
        return title.isEmpty() || prompt.contains(title) ? prompt : prompt + " (" + event + ")";
    }

    private static String whom(Activation asked) {
        List<String> named = new ArrayList<>(asked.proxies());
        asked.tasks().stream().map(TaskId::name).forEach(named::add);
        return named.isEmpty() ? "" : ", of " + String.join(", ", named);
    }

    /** The activation that is answered; empty where none is. */
    Optional<Activation> asked() {
        return of instanceof What.Respond respond ? Optional.of(respond.asked()) : Optional.empty();
    }
}
