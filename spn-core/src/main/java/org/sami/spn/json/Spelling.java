package org.sami.spn.json;

import java.util.Locale;

/** Whether two words are so alike that one is probably a misspelling of the other. */
final class Spelling {
    private static final int MOST_EDITS = 3;

    private Spelling() {}

    static boolean alike(String a, String b) {
        String x = plain(a);
        String y = plain(b);
        return Math.abs(x.length() - y.length()) <= MOST_EDITS
                && levenshtein(x, y) <= Math.min(MOST_EDITS, Math.max(1, x.length() / 4));
    }

    /** By how many letters two words differ, whatever their case. */
    static int distance(String a, String b) {
        return levenshtein(plain(a), plain(b));
    }

    private static String plain(String word) {
        return word.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "");
    }

    private static int levenshtein(String a, String b) {
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int substituted = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(substituted, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[b.length()];
    }
}
