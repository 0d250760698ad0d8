package org.sami.crw.session.fault;

import java.util.Optional;
import java.util.function.Supplier;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Priority;

/** Says that a journal's database does not answer before missions have to stand still for it. */
final class DatabaseWatch {
    /** What the fault is about: the one without a name says that missions stand still. */
    static final String SUBJECT = "database";

    private final Supplier<Optional<String>> warning;

    /** @param warning why the journal may soon not be written; empty while all is well */
    DatabaseWatch(Supplier<Optional<String>> warning) {
        this.warning = warning;
    }

    /** What is wrong now; empty while all is well. */
    Optional<HealthFault> look() {
        return warning.get()
                .map(why -> HealthFault.of(
                                HealthKind.JOURNAL,
                                SUBJECT,
                                Priority.HIGH,
                                "The journal's database is not reached: " + why,
                                "See to the database and the network to it")
                        .withDetails(
                                "Missions go on for the moment, and stand still within seconds unless it answers"));
    }
}
