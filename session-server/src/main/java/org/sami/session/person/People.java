package org.sami.session.person;

import java.util.List;
import java.util.Optional;

/** Who may take part in a session. From any thread. */
public interface People {
    /** The person of a name and key; empty for a wrong name or key. */
    Optional<Person> login(String name, String key);

    /** The person as listed now; empty for one who was removed, or has another key by now. */
    Optional<Person> present(Person earlier);

    /** Why the list cannot be read at present; empty where it can. */
    Optional<String> fault();

    /** Whether logins need a key. */
    boolean needKeys();

    /** Whoever is on this machine: no key, and every right. For a loopback address only. */
    static People ofThisMachine() {
        return new People() {
            @Override
            public Optional<Person> login(String name, String key) {
                try {
                    return Optional.of(new Person(name, PersonRole.OPERATOR, List.of(), ""));
                } catch (IllegalArgumentException unfit) {
                    return Optional.empty();
                }
            }

            @Override
            public Optional<Person> present(Person earlier) {
                return Optional.of(earlier);
            }

            @Override
            public Optional<String> fault() {
                return Optional.empty();
            }

            @Override
            public boolean needKeys() {
                return false;
            }
        };
    }
}
