package org.sami.spn.finding;

import java.util.Objects;

/**
 * What helps an author with all findings of one code; the finding itself says what is wrong and where.
 *
 * @param code the stable code of the findings
 * @param why what goes wrong in a mission if it stays so, in a sentence
 * @param mend what the author can do about it, in a sentence
 */
public record Advice(String code, String why, String mend) {
    public Advice {
        Objects.requireNonNull(code, "code");
        Objects.requireNonNull(why, "why");
        Objects.requireNonNull(mend, "mend");
    }
}
