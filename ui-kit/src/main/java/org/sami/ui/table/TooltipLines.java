package org.sami.ui.table;

import java.text.BreakIterator;
import java.util.Locale;

/** Breaks the text of a tooltip into lines, since a tooltip shows a line as long as it is, beyond the window too. */
public final class TooltipLines {
    private static final int MOST_CHARACTERS = 80;

    private TooltipLines() {}

    /** The same text with line breaks where words end; a longer word has a line of its own. */
    public static String of(String text) {
        BreakIterator words = BreakIterator.getLineInstance(Locale.ENGLISH);
        words.setText(text);
        StringBuilder lines = new StringBuilder();
        int lineBegin = 0;
        int from = words.first();
        for (int to = words.next(); to != BreakIterator.DONE; from = to, to = words.next()) {
            String word = text.substring(from, to);
            if (lines.length() > lineBegin
                    && lines.length() - lineBegin + word.strip().length() > MOST_CHARACTERS) {
                lines.setLength(lines.toString().stripTrailing().length());
                lines.append('\n');
                lineBegin = lines.length();
            }
            lines.append(word);
        }
        return lines.toString().stripTrailing();
    }
}
