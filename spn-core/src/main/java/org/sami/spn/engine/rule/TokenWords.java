package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.protocol.Token;

/** Tokens as notes and questions speak of them. */
public final class TokenWords {
    private TokenWords() {}

    /** Names of robots and tasks in a row; nobody where there is none. */
    public static String of(List<Token> tokens) {
        List<String> words = new ArrayList<>();
        for (Token token : tokens) {
            if (token instanceof Token.Proxy proxy) {
                words.add(proxy.proxy());
            } else if (token instanceof Token.Task task) {
                words.add("task " + task.task().name());
            } else {
                words.add("a generic token");
            }
        }
        return words.isEmpty() ? "nobody" : String.join(", ", words);
    }
}
