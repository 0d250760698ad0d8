package org.sami.session.server;

import java.util.Optional;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.session.person.People;
import org.sami.spn.protocol.Priority;

/** Reports a list of people that cannot be read as a fault of the session, for as long as it cannot. For one thread. */
final class PeopleWatch {
    private static final String SUBJECT = "the list of people";

    private final People people;
    private final HealthModel health;
    private Optional<String> said = Optional.empty();

    PeopleWatch(People people, HealthModel health) {
        this.people = people;
        this.health = health;
    }

    /** Looks at the list as it is now. */
    void look() {
        Optional<String> fault = people.fault();
        if (fault.equals(said)) {
            return;
        }
        said = fault;
        fault.ifPresentOrElse(
                why -> health.report(HealthFault.of(
                                HealthKind.FILE,
                                SUBJECT,
                                Priority.MEDIUM,
                                "The list of people cannot be read: who is connected stays, nobody else gets in",
                                "Put the file right on the machine of the base, or list the people anew there")
                        .withDetails(why)),
                () -> health.over(HealthKind.FILE, SUBJECT));
    }
}
