package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;

/** Whom an occurrence names: tasks, or where it names none, boats; written as the tokens of that task or boat. */
final class Names {
    private Names() {}

    /** An aborted child's starting tokens are all named, its boats and its tasks. */
    static List<Token> ofAborted(Occurrence occurrence) {
        Set<Token> names = new LinkedHashSet<>(of(occurrence));
        occurrence.proxies().forEach(proxy -> names.add(new Token.Proxy(proxy)));
        return new ArrayList<>(names);
    }

    static List<Token> of(Occurrence occurrence) {
        Set<Token> names = new LinkedHashSet<>();
        occurrence.tasks().forEach(task -> names.add(new Token.Task(task)));
        if (names.isEmpty()) {
            occurrence.proxies().forEach(proxy -> names.add(new Token.Proxy(proxy)));
        }
        return new ArrayList<>(names);
    }
}
