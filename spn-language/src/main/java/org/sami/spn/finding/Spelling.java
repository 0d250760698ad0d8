package org.sami.spn.finding;

import java.util.Locale;

/** Whether two words are so alike that one is probably a misspelling of the other. */
final class Spelling {
    private static final int MOST_EDITS = 3;

    private Spelling() {}

    static boolean alike(String a, String b) {
        String x = plain(a);
        String y = plain(b);
        return Math.abs(x.length() - y.length()) <= MOST_EDITS
                && edits(x, y) <= Math.min(MOST_EDITS, Math.max(1, x.length() / 4));
    }

    /** By how many letters two words differ, whatever their case; two neighbours that changed places count once. */
    static int distance(String a, String b) {
        return edits(plain(a), plain(b));
    }

    private static String plain(String word) {
        return word.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "");
    }

    private static int edits(String a, String b) {
        int[] beforeLast = new int[b.length() + 1];
        int[] last = new int[b.length() + 1];
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            last[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                boolean same = a.charAt(i - 1) == b.charAt(j - 1);
                row[j] = Math.min(last[j - 1] + (same ? 0 : 1), 1 + Math.min(last[j], row[j - 1]));
                boolean swapped =
                        i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
                if (swapped) {
                    row[j] = Math.min(row[j], beforeLast[j - 2] + 1);
                }
            }
            int[] oldest = beforeLast;
            beforeLast = last;
            last = row;
            row = oldest;
        }
        return last[b.length()];
    }
}
