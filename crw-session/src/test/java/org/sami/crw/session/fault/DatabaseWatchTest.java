package org.sami.crw.session.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.health.HealthFault;

/** What an operator sees of a database that does not answer. */
class DatabaseWatchTest {
    private final AtomicReference<Optional<String>> warning = new AtomicReference<>(Optional.empty());
    private final DatabaseWatch watch = new DatabaseWatch(warning::get);

    @Test
    void databaseThatDoesNotAnswerIsToldAndNoLongerOnceItDoes() {
        assertThat(watch.look()).isEmpty();

        warning.set(Optional.of("no database answers there"));
        assertThat(watch.look())
                .map(HealthFault::text)
                .contains("The journal's database is not reached: no database answers there");

        warning.set(Optional.empty());
        assertThat(watch.look()).isEmpty();
    }
}
