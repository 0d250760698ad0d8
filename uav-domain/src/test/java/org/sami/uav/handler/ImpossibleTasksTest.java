package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TaskId;

/** Of which aircraft a task that none can do is said, in a session with an engine. */
class ImpossibleTasksTest {
    private static final TaskId TASK = new TaskId(1, "Search 1");

    private final FlightHandlerHarness harness = new FlightHandlerHarness(2);
    private final ArrayDeque<Runnable> work = new ArrayDeque<>();
    private final List<String> messages = new ArrayList<>();
    private EngineHost host;
    private TaskFailures failures;

    private static final class Standing implements HostClock {
        @Override
        public long nowMillis() {
            return 0;
        }

        @Override
        public void wakeAt(long millis, Runnable action) {}
    }

    @BeforeEach
    void joinThemAll() {
        Engine engine = new Engine(UavRuns.DOMAIN.vocabulary(), UavRuns.DOMAIN.combined());
        host = EngineHostBuilder.of(engine, engine.newState())
                .clock(new Standing())
                .executor(work::add)
                .build();
        failures = new TaskFailures(
                Runnable::run,
                new ImpossibleTasks(host, harness.fleet.proxies(), message -> messages.add(message.text())),
                new TaskFailureMemory(host));
        harness.pass(5);
    }

    private void post(Input input) {
        host.post(input);
        while (!work.isEmpty()) {
            work.remove().run();
        }
    }

    private void failTwice(String copter) {
        harness.allocation.put(TASK, copter);
        for (int i = 0; i < 2; i++) {
            harness.step(
                    failures,
                    new Input.Received(new Occurrence(UavEvents.CANNOT_FLY, 1, 1, List.of(), List.of(TASK), Map.of())));
        }
    }

    @Test
    void taskIsImpossibleWhereTheOnesThatHaveNotFailedWereDropped() {
        post(new Input.ProxyJoined("copter1"));
        post(new Input.ProxyJoined("copter2"));
        post(new Input.ProxyDropped("copter2", Ids.NONE));
        failTwice("copter1");

        assertThat(messages)
                .containsExactly("No aircraft can or may do Search 1: copter1 failed at it twice. It waits for another"
                        + " battery");
    }

    @Test
    void taskIsNotImpossibleWhereThereAreNoAircraft() {
        failTwice("copter1");

        assertThat(messages).isEmpty();
    }
}
