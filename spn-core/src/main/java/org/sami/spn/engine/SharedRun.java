package org.sami.spn.engine;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.sami.spn.protocol.Token;

/** The static instance on a place, with its returns that no firing has used, oldest first. */
final class SharedRun {
    /** One completion: the tokens that left the child with it, as the parent names them. */
    record Return(List<Token> tokens, String value) {
        Return {
            tokens = new ArrayList<>(tokens);
        }
    }

    final Instance instance;
    final ArrayDeque<Return> returns = new ArrayDeque<>();

    SharedRun(Instance instance) {
        this.instance = instance;
    }
}
