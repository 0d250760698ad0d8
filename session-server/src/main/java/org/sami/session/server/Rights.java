package org.sami.session.server;

import org.sami.session.api.RefusedException;
import org.sami.session.person.Person;
import org.sami.session.person.Right;

/** Refuses what a person's role does not allow. */
final class Rights {
    private Rights() {}

    /** @throws RefusedException in words, if the role does not give the right */
    static void require(Person person, Right right) {
        if (!person.may(right)) {
            throw new RefusedException("The role " + person.role().word() + " of " + person.name()
                    + " does not have the right '" + right.word() + "'");
        }
    }
}
