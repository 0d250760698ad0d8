package org.sami.spn.edit;

import java.util.Objects;

/**
 * An edit that mends what a finding is about.
 *
 * @param label what it does, as an instruction to the program, such as {@code Stop writing @path}
 */
public record Fix(String label, Edit edit) {
    public Fix {
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(edit, "edit");
    }
}
