package org.sami.spn.edit;

import java.util.Optional;
import org.sami.spn.vocabulary.Reserved;

/** What the reader would refuse as the name of a variable. */
final class VariableNameForm {
    private static final String VARIABLE = "@[A-Za-z][A-Za-z0-9_.]*";

    private VariableNameForm() {}

    /** Why a text is no name of a variable; empty where it is one. */
    static Optional<String> problem(String name) {
        if (name.equals(Reserved.TASK_VARIABLE)) {
            return Optional.of("@task is reserved: it reads a field from the entering task");
        }
        return name.matches(VARIABLE)
                ? Optional.empty()
                : Optional.of("\"" + name + "\" is no name of a variable: that is @ and a letter, then letters, digits,"
                        + " points");
    }
}
