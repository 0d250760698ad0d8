package org.sami.spn.protocol;

import java.util.Objects;
import java.util.Optional;

/** What happened to one token in a firing: from = removed there, to = added there, both = moved. */
public record TokenMove(Token token, Optional<String> from, Optional<String> to) {
    public TokenMove {
        Objects.requireNonNull(token, "token");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(to, "to");
    }
}
