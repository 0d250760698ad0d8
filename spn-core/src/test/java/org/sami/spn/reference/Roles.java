package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/** What the engine itself does with activations: timers, and the other roles of the vocabulary; decisions are {@link Questions}. */
final class Roles {
    /** What the interpreter's inputs do, for the roles that ask for the same. */
    interface Operations {
        void abort(Mission m);

        void complete(Mission m);
    }

    private final World world;
    private final Attention attention;
    private final Operations operations;
    /** What is asked of the operator. */
    final Questions questions;

    Roles(World world, Attention attention, Operations operations) {
        this.world = world;
        this.attention = attention;
        this.operations = operations;
        this.questions = new Questions(world, attention);
    }

    void activated(Visit visit, Activation activation, boolean missionEnds) {
        EventType type = world.eventType(activation.type());
        Mission m = visit.mission;
        if (type.role() == EventRole.RETURN_VALUE) {
            m.returnValue = activation.value("value");
        } else if (type.role() == EventRole.APPLY_ALLOCATION) {
            activation.value("tasks").ifPresent(this::apply);
        }
        // R-END-7
        m.abortAsked |= type.role() == EventRole.ABORT_MISSION;
        m.completionAsked |= type.role() == EventRole.COMPLETE_MISSION;
        if (missionEnds) {
            return;
        }
        switch (type.role()) {
            case TIMER -> startTimer(activation, Optional.empty());
            case PROXY_TIMER ->
                new LinkedHashSet<>(activation.tokens()).forEach(token -> {
                    if (token instanceof Token.Proxy
                            || (token instanceof Token.Task t
                                    && activation.allocation().containsKey(t.task()))) {
                        startTimer(activation, Optional.of(token));
                    }
                });
            case GET_ALL_TOKENS ->
                world.internal.add(() -> {
                    if (m.status != Mission.Status.ENDED) { // nobody is told that the engine's own answer is late
                        answer(activation, typeOf(EventRole.TOKENS_RETURNED), world.proxies, List.of(), Map.of());
                    }
                });
            case ABORT_MISSION -> world.internal.add(() -> operations.abort(m));
            case COMPLETE_MISSION -> world.internal.add(() -> operations.complete(m));
            default -> {}
        }
        type.decision().ifPresent(decision -> questions.open(visit, activation, decision));
    }

    private String typeOf(EventRole role) {
        return world.vocabulary.eventWithRole(role).orElseThrow().name();
    }

    private void answer(
            Activation activation, String type, List<String> proxies, List<TaskId> tasks, Map<String, Value> values) {
        attention.receive(Occurrence.answer(type, activation, proxies, tasks, values));
    }

    private void apply(Value allocation) {
        Map<TaskId, Optional<String>> robots = new LinkedHashMap<>();
        ((MapValue) allocation)
                .entries()
                .forEach((task, proxy) -> robots.put((TaskId) task, Optional.of(((ProxyValue) proxy).proxy())));
        new Allocating(world).allocate(robots);
    }

    // ---- Timers (R-VIS-6)

    private void startTimer(Activation activation, Optional<Token> token) {
        Value duration = activation.value("duration").orElse(new DurationValue(0));
        long due = world.now + ((DurationValue) duration).millis();
        world.clocks.add(new World.Clock(due, world.nextClock++, Optional.of(activation), token, 0));
    }

    void ring(World.Clock clock) {
        world.clocks.remove(clock);
        if (clock.timer().isEmpty()) {
            questions.answerByAutonomy(clock.decision());
            return;
        }
        Activation activation = clock.timer().get();
        if (clock.token().isEmpty()) {
            answer(activation, typeOf(EventRole.TIMER_EXPIRED), List.of(), List.of(), Map.of());
            return;
        }
        List<String> proxies = new ArrayList<>();
        List<TaskId> tasks = new ArrayList<>();
        Token token = clock.token().get();
        if (token instanceof Token.Proxy boat) {
            proxies.add(boat.proxy());
        } else if (token instanceof Token.Task task) {
            world.boatOf(task.task()).ifPresent(proxies::add); // whose it is now
            tasks.add(task.task());
        }
        answer(activation, typeOf(EventRole.PROXY_TIMER_EXPIRED), proxies, tasks, Map.of());
    }
}
