package org.sami.crw.session.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.health.HealthFault;
import org.sami.spn.journal.StoredJournal;

class SystemWatchTest {
    private static final double WAIT_S = 60;

    private final List<HealthFault> told = new CopyOnWriteArrayList<>();
    private final AtomicInteger looks = new AtomicInteger();

    /** A journal in a database of which only the warning is asked, and that fails. */
    private StoredJournal failing() {
        return (StoredJournal) Proxy.newProxyInstance(
                getClass().getClassLoader(), new Class<?>[] {StoredJournal.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("inFile")) {
                        return Optional.empty();
                    }
                    looks.incrementAndGet();
                    throw new IllegalStateException("a gap");
                });
    }

    @Test
    void databaseIsLookedAtAgainAfterALookThatFailedAndTheFaultIsTold() throws Exception {
        OperatorModels models = new OperatorModels(Runnable::run, () -> 0);
        try (SystemWatch watch =
                new SystemWatch(Optional.of(failing()), models.health(), new ThreadGuard(told::add, reason -> {}))) {
            Await.until("it is looked at twice", WAIT_S, () -> looks.get() > 1);

            assertThat(watch.watchesDatabase()).isTrue();
            assertThat(told)
                    .isNotEmpty()
                    .allMatch(fault ->
                            fault.text().contains("a gap") || fault.details().contains("a gap"));
        }
    }
}
