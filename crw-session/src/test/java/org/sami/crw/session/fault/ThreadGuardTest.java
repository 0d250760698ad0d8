package org.sami.crw.session.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;

class ThreadGuardTest {
    private final List<HealthFault> health = new ArrayList<>();
    private final List<String> stopped = new ArrayList<>();
    private final ThreadGuard guard = new ThreadGuard(health::add, stopped::add);

    @Test
    void memoryThatRanOutStopsTheSessionAlsoInsideAnotherFault() {
        guard.caught("engine", new CompletionException(new OutOfMemoryError("Java heap space")));

        assertThat(stopped).containsExactly("memory ran out (Java heap space) on the thread 'engine'");
        assertThat(health).extracting(HealthFault::kind).containsExactly(HealthKind.MEMORY);
    }

    @Test
    void memoryThatRanOutWhereAFileIsReadCostsThatFileOnly() {
        guard.lost("files", new OutOfMemoryError("Java heap space"));

        assertThat(stopped).isEmpty();
        assertThat(health)
                .extracting(HealthFault::text)
                .containsExactly("The program has a fault: memory ran out (Java heap space)");
        assertThat(health.get(0).details()).startsWith("It was met on the thread 'files'");
    }

    @Test
    void faultsOfTheCodeAreCountedByThreadAndStopNothing() {
        guard.uncaughtException(new Thread("AWT-EventQueue-0"), new IllegalStateException("a gap"));
        guard.caught("AWT-EventQueue-0", new StackOverflowError());

        assertThat(stopped).isEmpty();
        assertThat(health)
                .extracting(HealthFault::subject, HealthFault::text, HealthFault::details)
                .containsExactly(
                        tuple(
                                "AWT-EventQueue-0",
                                "A part of the program (thread 'AWT-EventQueue-0') met an error",
                                "java.lang.IllegalStateException: a gap"),
                        tuple(
                                "AWT-EventQueue-0",
                                "A part of the program (thread 'AWT-EventQueue-0') met 2 errors",
                                "The last: java.lang.StackOverflowError"));
    }

    @Test
    void aFaultInTheTellingReachesNobody() {
        ThreadGuard broken = new ThreadGuard(
                fault -> {
                    throw new OutOfMemoryError("again");
                },
                reason -> {
                    throw new IllegalStateException("nobody listens");
                });

        broken.caught("engine", new OutOfMemoryError("Java heap space"));
        broken.lost("files", new IllegalStateException("a gap"));
    }

    @Test
    void aCauseThatIsItsOwnEndsTheSearch() {
        Exception one = new Exception("one");
        Exception two = new Exception("two", one);
        one.initCause(two);

        guard.caught("engine", two);
        assertThat(health).extracting(HealthFault::kind).containsExactly(HealthKind.THREAD);
    }
}
