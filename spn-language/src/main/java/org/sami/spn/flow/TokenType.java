package org.sami.spn.flow;

import java.util.EnumSet;
import java.util.Set;
import org.sami.spn.model.TokenKind;

/** What a token is, where a {@link TokenKind} says which tokens a requirement asks for. */
public enum TokenType {
    GENERIC,
    PROXY,
    TASK;

    /** The tokens that a requirement speaks of; of relevant ones those that have a name. */
    public static Set<TokenType> of(TokenKind kind) {
        return switch (kind) {
            case GENERIC -> EnumSet.of(TokenType.GENERIC);
            case ANY_PROXY -> EnumSet.of(TokenType.PROXY);
            case ANY_TASK, TASK -> EnumSet.of(TokenType.TASK);
            case ANY_TOKEN -> EnumSet.allOf(TokenType.class);
            case RELEVANT -> EnumSet.of(TokenType.PROXY, TokenType.TASK);
            case SUB_MISSION_TOKENS, UNCONDITIONAL -> EnumSet.noneOf(TokenType.class);
        };
    }
}
