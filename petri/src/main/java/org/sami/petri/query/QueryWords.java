package org.sami.petri.query;

import java.util.ArrayList;
import java.util.List;

/** The text of a query, cut into words, numbers and signs. For one thread. */
final class QueryWords {
    private static final List<String> SIGNS = List.of("<=", ">=", "!=", "<", ">", "=", "(", ")", "+", "-", "*");

    private final List<Word> words = new ArrayList<>();
    private final String text;
    private int at;

    /**
     * A word.
     *
     * @param isQuoted whether it stood in double quotes: then it is a name and nothing else
     */
    record Word(String text, int column, boolean isQuoted) {
        boolean is(String other) {
            return !isQuoted && text.equals(other);
        }

        /** The word as a message shows it. */
        String shown() {
            return text.isEmpty() && !isQuoted ? "the end" : "'" + text + "'";
        }
    }

    QueryWords(String text) throws QueryFaultException {
        this.text = text;
        int i = 0;
        while (i < text.length()) {
            int from = i;
            if (Character.isWhitespace(text.charAt(i))) {
                i++;
            } else if (text.charAt(i) == '"') {
                i = quoted(text, from);
            } else {
                i = plain(text, from);
            }
        }
        words.add(new Word("", text.length() + 1, false));
    }

    private int quoted(String text, int from) throws QueryFaultException {
        StringBuilder name = new StringBuilder();
        int i = from + 1;
        while (i < text.length() && text.charAt(i) != '"') {
            if (text.charAt(i) == '\\' && i + 1 < text.length()) {
                i++;
            }
            name.append(text.charAt(i++));
        }
        if (i >= text.length()) {
            throw new QueryFaultException(from + 1, "the quotation that begins here has no end");
        }
        words.add(new Word(name.toString(), from + 1, true));
        return i + 1;
    }

    private int plain(String text, int from) throws QueryFaultException {
        for (String sign : SIGNS) {
            if (text.startsWith(sign, from)) {
                words.add(new Word(sign, from + 1, false));
                return from + sign.length();
            }
        }
        int i = from;
        while (i < text.length() && isOfWord(text.charAt(i))) {
            i++;
        }
        if (i == from) {
            throw new QueryFaultException(
                    from + 1,
                    "'" + text.charAt(from) + "' has no meaning here; names with such signs stand in \"quotes\"");
        }
        words.add(new Word(text.substring(from, i), from + 1, false));
        return i;
    }

    private static boolean isOfWord(char c) {
        return Character.isLetterOrDigit(c) || c == '_' || c == '.' || c == ':' || Character.isSurrogate(c);
    }

    Word peek() {
        return words.get(at);
    }

    Word next() {
        Word word = words.get(at);
        at = Math.min(at + 1, words.size() - 1);
        return word;
    }

    /** Whether the next word is this one; then it is passed. */
    boolean skip(String word) {
        if (peek().is(word)) {
            next();
            return true;
        }
        return false;
    }

    void expect(String word) throws QueryFaultException {
        Word found = next();
        if (!found.is(word)) {
            throw new QueryFaultException(found.column(), "expected is '" + word + "', not " + found.shown());
        }
    }

    /** Whether a sum of tokens follows, not a name alone. */
    boolean isSum() {
        Word first = peek();
        boolean opens = at + 1 < words.size() && words.get(at + 1).is("(");
        return first.is("-")
                || (first.is("m") && opens)
                || (!first.isQuoted() && first.text().matches("\\d+"));
    }

    /** The words from one that was passed to the next. */
    String since(Word from) {
        return text.substring(from.column() - 1, peek().column() - 1).strip();
    }
}
