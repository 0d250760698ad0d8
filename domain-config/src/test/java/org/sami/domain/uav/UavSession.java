package org.sami.domain.uav;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.function.Consumer;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.Value;

/** The domain's composition: a host with the engine, the handlers and simulated aircraft, in virtual time on the test's thread. */
final class UavSession implements HostClock {
    static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/uav").orThrow();

    private final Queue<Runnable> work = new ArrayDeque<>();
    private final List<Effect> effects = new ArrayList<>();
    private final Flight flight = new Flight();
    private final EngineHost host;
    private long nowMs;
    private long wakeMs = Long.MAX_VALUE;
    private Runnable wake = () -> {};

    UavSession(Map<String, SimulatedUav> aircraft) {
        Engine engine = new Engine(DOMAIN.vocabulary(), DOMAIN.combined());
        host = EngineHostBuilder.of(engine, engine.newState())
                .clock(this)
                .executor(work::add)
                .build();
        host.addListener((index, atMillis, input, stepped, view) -> effects.addAll(stepped));
        aircraft.forEach(flight::add);
        flight.install(host);
        aircraft.keySet().forEach(name -> post(new Input.ProxyJoined(name)));
    }

    Flight flight() {
        return flight;
    }

    /** All effects so far. */
    List<Effect> effects() {
        return effects;
    }

    void follow(Consumer<Effect> follower) {
        host.addListener((index, atMillis, input, stepped, view) -> stepped.forEach(follower));
    }

    void start(String plan, Map<String, Value> values) {
        post(new Input.StartMission(plan, "", values));
    }

    /** The decisions that are open, the oldest first. */
    List<Decision> decisions() {
        return host.ask(view -> view.decisions());
    }

    /** Answers the only open decision. */
    void answer(Answer answer) {
        List<Decision> open = decisions();
        if (open.size() != 1) {
            throw new IllegalStateException("Not one decision is open but " + open);
        }
        post(new Input.AnswerDecision(open.get(0).id(), answer, Answerer.OPERATOR));
    }

    void fly(int seconds) {
        for (int tenth = 0; tenth < 10 * seconds; tenth++) {
            nowMs += 100;
            if (nowMs >= wakeMs) {
                wakeMs = Long.MAX_VALUE;
                wake.run();
            }
            flight.step(0.1);
            drain();
        }
    }

    void post(Input input) {
        host.post(input);
        drain();
    }

    private void drain() {
        for (Runnable next = work.poll(); next != null; next = work.poll()) {
            next.run();
        }
    }

    List<Outcome> outcomes() {
        return effects.stream()
                .filter(Effect.MissionEnded.class::isInstance)
                .map(effect -> ((Effect.MissionEnded) effect).outcome())
                .toList();
    }

    @Override
    public long nowMillis() {
        return nowMs;
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        wakeMs = millis;
        wake = action;
    }
}
