package org.sami.spn.engine;

import org.sami.spn.protocol.Token;

/**
 * One robot or task that a pending occurrence names, with the tokens it speaks of: itself, and for a robot the tasks
 * allocated to it among those of the answered activation (SEMANTICS, Input events, relevant tokens).
 */
final class Name {
    final Pending pending;
    final Token token;
    Token[] tokens;
    boolean struck;
    /** Whether one of its tokens stood in the answered visit or an in place when it arrived. */
    boolean stood;

    Name(Pending pending, Token token) {
        this.pending = pending;
        this.token = token;
        this.tokens = new Token[] {token};
    }
}
