package org.sami.spn.reference;

import org.sami.spn.protocol.Token;

/** One copy of a token in a place; it belongs to the visit by which it entered (R-VIS-1). Compared by identity. */
final class Copy {
    final Token token;
    final Visit visit;

    Copy(Token token, Visit visit) {
        this.token = token;
        this.visit = visit;
    }
}
