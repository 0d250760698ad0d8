package org.sami.spn.flow;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/**
 * Whom an occurrence of an input event can name, and so which relevant tokens its transition can have (R-REL-1, R-REL-3): what the event's
 * type needs, and for events of the engine what their role says.
 */
public final class NamedTokens {
    private NamedTokens() {}

    /** The kinds of tokens that occurrences of a type can name; none where they name nobody. */
    public static Set<TokenType> of(EventType type) {
        Set<TokenType> named = byRole(type.role());
        switch (type.tokens()) {
            case PROXY -> named.add(TokenType.PROXY);
            case TASK -> named.add(TokenType.TASK);
            case PROXY_OR_TASK -> {
                named.add(TokenType.PROXY);
                named.add(TokenType.TASK);
            }
            case NONE -> {}
        }
        return Collections.unmodifiableSet(named);
    }

    private static Set<TokenType> byRole(EventRole role) {
        return switch (role) {
            case TOKENS_RETURNED, INTERRUPT, GENERAL_INTERRUPT_RECEIVED, PROXY_INTERRUPT_RECEIVED ->
                EnumSet.of(TokenType.PROXY);
            case TASKS_GENERATED -> EnumSet.of(TokenType.TASK);
            case PROXY_TIMER_EXPIRED, SUB_MISSION_ABORTED -> EnumSet.of(TokenType.PROXY, TokenType.TASK);
            default -> EnumSet.noneOf(TokenType.class);
        };
    }
}
