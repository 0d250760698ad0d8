package org.sami.spn.engine.state;

import org.sami.spn.protocol.Token;

/**
 * One robot or task that a pending occurrence names, with the tokens it speaks of: itself, and for a robot the tasks
 * allocated to it among those of the answered activation (R-REL-3).
 */
public final class NamedToken {
    public final Token token;
    public Token[] tokens;
    public boolean struck;
    /** Whether one of its tokens stood in the answered visit or an in place when it arrived. */
    public boolean stood;

    public NamedToken(Token token) {
        this.token = token;
        this.tokens = new Token[] {token};
    }

    /** The same name in the copy of a state. */
    NamedToken copy() {
        NamedToken n = new NamedToken(token);
        n.tokens = tokens; // replaced, never changed
        n.struck = struck;
        n.stood = stood;
        return n;
    }
}
