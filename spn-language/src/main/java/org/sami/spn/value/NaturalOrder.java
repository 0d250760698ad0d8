package org.sami.spn.value;

import java.util.Comparator;
import java.util.Locale;

/** The order of names in lists: the alphabet, without regard to case, with numbers by their size: boat-2 comes before boat-10. */
public final class NaturalOrder implements Comparator<String> {
    public static final NaturalOrder INSTANCE = new NaturalOrder();

    private NaturalOrder() {}

    @Override
    public int compare(String first, String second) {
        String a = first.toLowerCase(Locale.ROOT);
        String b = second.toLowerCase(Locale.ROOT);
        int i = 0;
        int j = 0;
        while (i < a.length() && j < b.length()) {
            int iEnd = endOfRun(a, i);
            int jEnd = endOfRun(b, j);
            int order = isDigit(a.charAt(i)) && isDigit(b.charAt(j))
                    ? bySize(a.substring(i, iEnd), b.substring(j, jEnd))
                    : a.substring(i, iEnd).compareTo(b.substring(j, jEnd));
            if (order != 0) {
                return order;
            }
            i = iEnd;
            j = jEnd;
        }
        int rest = Integer.compare(a.length() - i, b.length() - j);
        return rest == 0 ? first.compareTo(second) : rest;
    }

    /** Digits go together; all else stands by itself. */
    private static int endOfRun(String text, int from) {
        int end = from + 1;
        while (isDigit(text.charAt(from)) && end < text.length() && isDigit(text.charAt(end))) {
            end++;
        }
        return end;
    }

    private static int bySize(String a, String b) {
        String left = a.replaceFirst("^0+(?=.)", "");
        String right = b.replaceFirst("^0+(?=.)", "");
        int byLength = Integer.compare(left.length(), right.length());
        return byLength == 0 ? left.compareTo(right) : byLength;
    }

    private static boolean isDigit(char c) {
        return c >= '0' && c <= '9';
    }
}
