package org.sami.spn.host;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Tiny plans, each of which makes a host do one thing; and words for them. */
public final class HostPlans {
    /** The test words, and {@code Drive}, a command (answered by Done), and {@code Tell}, which nobody answers. */
    public static final Vocabulary VOCABULARY = vocabulary();

    /** One plan per output event: {@code Do}, {@code Drive}, {@code Tell}, {@code Approve}; {@code timer}, {@code watch}. */
    public static final Project PROJECT = NetBuilder.project(
            List.of(new VariableSpec("@n", ValueType.Simple.INTEGER, Optional.empty())),
            asking("Do", "Done"),
            asking("Drive", "Done"),
            asking("Tell", "News"),
            asking("Approve", "Yes"),
            asking("GetAll", "GotAll"),
            timer(),
            asking("watch", "Pose"));

    private HostPlans() {}

    public static Engine engine() {
        return new Engine(VOCABULARY, PROJECT);
    }

    public static Input start(String plan) {
        return new Input.StartMission(plan, plan, Map.of());
    }

    /** An input that does nothing but carry a number. */
    public static Input number(long n) {
        return new Input.SetVariable(Ids.NONE, "@n", new IntegerValue(n));
    }

    public static long numberOf(Input input) {
        return ((IntegerValue) ((Input.SetVariable) input).value()).value();
    }

    private static Plan asking(String event, String answer) {
        NetBuilder net = new NetBuilder(event).start("asked");
        if (!event.equals("watch")) {
            net.output("asked", event);
        }
        return net.end("end")
                .transition("answered", answer)
                .in("asked", "answered", "generic >= 1")
                .out("answered", "end", "take all any")
                .build();
    }

    private static Plan timer() {
        return new NetBuilder("timer")
                .start("wait")
                .output(
                        "wait",
                        "StartTimer",
                        Map.of("duration", new FieldSource.Fixed(new DurationValue(1000))),
                        Map.of())
                .end("end")
                .transition("over", "TimerExpired")
                .in("wait", "over", "generic >= 1")
                .out("over", "end", "take all any")
                .build();
    }

    private static Vocabulary vocabulary() {
        Vocabulary test = TestVocabulary.TEST;
        List<EventType> events = new ArrayList<>(test.events().values());
        events.add(output("Drive", List.of("Done"), Set.of(EventFlag.COMMAND)));
        events.add(output("Tell", List.of(), Set.of()));
        return new Vocabulary(
                "test",
                List.copyOf(test.types().values()),
                events,
                List.copyOf(test.markups().values()),
                List.copyOf(test.taskClasses().values()));
    }

    private static EventType output(String name, List<String> answers, Set<EventFlag> flags) {
        return new EventType(
                name,
                List.of(),
                Direction.OUTPUT,
                List.of(),
                TokenNeed.NONE,
                answers,
                EventRole.NONE,
                flags,
                Optional.empty(),
                name,
                "");
    }
}
