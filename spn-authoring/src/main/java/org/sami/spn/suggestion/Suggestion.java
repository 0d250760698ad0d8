package org.sami.spn.suggestion;

import java.util.List;
import java.util.Objects;
import org.sami.spn.edit.Edit;

/**
 * Requirements of an edge with which fewer findings are left.
 *
 * @param words the requirements in the words of the language, such as {@code ≥ 1 Proxy}
 * @param edit writes them on the edge
 * @param mended what they mend, a sentence a line
 * @param caused what they spoil, a sentence a line
 * @param fewer how many findings they remove
 * @param fresh how many findings they bring
 * @param left how many findings the plan has with them
 * @param complete whether every state was looked at; otherwise there may be findings further on
 */
public record Suggestion(
        String words,
        Edit edit,
        List<String> mended,
        List<String> caused,
        int fewer,
        int fresh,
        int left,
        boolean complete) {
    public Suggestion {
        Objects.requireNonNull(words, "words");
        Objects.requireNonNull(edit, "edit");
        mended = List.copyOf(mended);
        caused = List.copyOf(caused);
    }

    /** The balance in one line, such as {@code 2 findings fewer, 1 new, 3 left}. */
    public String balance() {
        return count(fewer) + " fewer" + (fresh == 0 ? "" : ", " + fresh + " new") + ", " + (left == 0 ? "none" : left)
                + " left" + (complete ? "" : " in the part that was searched");
    }

    private static String count(int findings) {
        return findings + (findings == 1 ? " finding" : " findings");
    }
}
