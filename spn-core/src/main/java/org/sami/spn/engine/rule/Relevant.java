package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.engine.state.Name;
import org.sami.spn.engine.state.Pending;
import org.sami.spn.protocol.Token;

/** The relevant tokens of a firing: of all names of the used occurrences, as a set (SEMANTICS, Input events). */
public final class Relevant {
    public static final Relevant NOBODY = new Relevant(new Name[0], new Token[0]);

    public final Name[] names;
    public final Token[] tokens;
    private Set<Token> set;

    private Relevant(Name[] names, Token[] tokens) {
        this.names = names;
        this.tokens = tokens;
    }

    public static Relevant of(List<Pending> used) {
        if (used.size() == 1) {
            Pending only = used.get(0);
            if (only.names.length == 0) {
                return NOBODY;
            }
            if (only.names.length == 1) {
                return new Relevant(only.names, only.names[0].tokens);
            }
        }
        List<Name> names = new ArrayList<>();
        Set<Token> tokens = new LinkedHashSet<>();
        for (Pending p : used) {
            for (Name n : p.names) {
                if (!n.struck) {
                    names.add(n);
                    tokens.addAll(List.of(n.tokens));
                }
            }
        }
        Relevant result = new Relevant(names.toArray(Name[]::new), tokens.toArray(Token[]::new));
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
