package org.sami.spn.testing;

import java.util.Locale;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;

/**
 * Requirements from words.
 *
 * <p>In: {@code "generic >= 1"}, {@code "proxy = 0"} (zero), {@code "any < 2"}, {@code "task == 2"} (exactly),
 * {@code "task:Name >= 1"} (one task or class), {@code "relevant all"}, {@code "relevant >= 1"}, {@code "always"}.
 *
 * <p>Out: {@code "take all proxy"}, {@code "take 1 generic"}, {@code "add 2 generic"}, {@code "consume all any"},
 * {@code "take all relevant"}, {@code "take all sub"}, {@code "take 1 task:Name"}, {@code "always"} (entry by nobody).
 */
public final class Requirements {
    private Requirements() {}

    /** An in requirement from words. */
    public static InRequirement in(String words) {
        String[] parts = words.trim().split("\\s+");
        if (parts[0].equals("always")) {
            return InRequirement.unconditional();
        }
        TokenKind kind = kind(parts[0]);
        String task = task(parts[0]);
        if (parts[1].equals("all")) {
            return new InRequirement(kind, Match.ALL, 0, task);
        }
        int n = Integer.parseInt(parts[2]);
        return switch (parts[1]) {
            case ">=" -> new InRequirement(kind, Match.AT_LEAST, n, task);
            case "<" -> new InRequirement(kind, Match.LESS_THAN, n, task);
            case "==" -> new InRequirement(kind, Match.EXACTLY, n, task);
            case "=" -> {
                if (n != 0) {
                    throw new IllegalArgumentException("= 0 is zero, == n is exactly: " + words);
                }
                yield new InRequirement(kind, Match.ZERO, 0, task);
            }
            default -> throw new IllegalArgumentException(words);
        };
    }

    /** An out requirement from words. */
    public static OutRequirement out(String words) {
        String[] parts = words.trim().split("\\s+");
        if (parts[0].equals("always")) {
            return OutRequirement.unconditional();
        }
        Action action = Action.valueOf(parts[0].toUpperCase(Locale.ROOT));
        int n = parts[1].equals("all") ? OutRequirement.ALL : Integer.parseInt(parts[1]);
        return new OutRequirement(kind(parts[2]), n, action, task(parts[2]));
    }

    private static TokenKind kind(String word) {
        if (word.startsWith("task:")) {
            return TokenKind.TASK;
        }
        return switch (word) {
            case "generic" -> TokenKind.GENERIC;
            case "proxy" -> TokenKind.ANY_PROXY;
            case "task" -> TokenKind.ANY_TASK;
            case "any" -> TokenKind.ANY_TOKEN;
            case "relevant" -> TokenKind.RELEVANT;
            case "sub" -> TokenKind.SUB_MISSION_TOKENS;
            default -> throw new IllegalArgumentException("No token kind: " + word);
        };
    }

    private static String task(String word) {
        return word.startsWith("task:") ? word.substring("task:".length()) : "";
    }
}
