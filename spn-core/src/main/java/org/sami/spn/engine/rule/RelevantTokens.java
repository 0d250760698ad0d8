package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.protocol.Token;

/**
 * The relevant tokens of a firing: of all names of the used occurrences, as a set.
 *
 * <p>Implements R-REL-2.
 */
public final class RelevantTokens {
    public static final RelevantTokens NOBODY = new RelevantTokens(new NamedToken[0], new Token[0]);

    public final NamedToken[] names;
    public final Token[] tokens;
    private @Nullable Set<Token> set;

    private RelevantTokens(NamedToken[] names, Token[] tokens) {
        this.names = names;
        this.tokens = tokens;
    }

    public static RelevantTokens of(List<PendingOccurrence> used) {
        if (used.size() == 1) {
            PendingOccurrence only = used.get(0);
            if (only.names.length == 0) {
                return NOBODY;
            }
            if (only.names.length == 1) {
                return new RelevantTokens(only.names, only.names[0].tokens);
            }
        }
        List<NamedToken> names = new ArrayList<>();
        Set<Token> tokens = new LinkedHashSet<>();
        for (PendingOccurrence p : used) {
            for (NamedToken n : p.names) {
                if (!n.struck) {
                    names.add(n);
                    tokens.addAll(List.of(n.tokens));
                }
            }
        }
        RelevantTokens result = new RelevantTokens(names.toArray(NamedToken[]::new), tokens.toArray(Token[]::new));
        result.set = tokens;
        return result;
    }

    public boolean contains(Token token) {
        if (set != null) {
            return set.contains(token);
        }
        for (Token t : tokens) {
            if (t.equals(token)) {
                return true;
            }
        }
        return false;
    }
}
