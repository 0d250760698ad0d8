package org.sami.spn.engine.codec;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Objects without names and facts about them, written so that two structures with equal facts have the same bytes whichever object is which
 * and in whatever order the facts came. Objects are distinguished by colour refinement: the colour of each is made of its own and of the facts that
 * speak of it, until no more are distinguished; of those that are left equal one is set apart, and so on. Where two of those are no mirror images
 * after all, two equal structures can have other bytes; other structures never have the same.
 */
final class LabelledStructure {
    private static final long SET_APART = 0x5bd1e995L;
    private static final long FACTOR = 0x9e3779b97f4a7c15L;

    private static final class Fact {
        private final String what;
        private final long hash;
        private final int[] objects;

        Fact(String what, int[] objects) {
            this.what = what;
            this.hash = mix(what.hashCode());
            this.objects = objects;
        }
    }

    private final Map<Object, Integer> objects = new HashMap<>();
    private final List<Long> first = new ArrayList<>();
    private final List<String> kinds = new ArrayList<>();
    private final List<Fact> facts = new ArrayList<>();

    /** The number of an object, which is new where it was not spoken of yet. */
    int object(Object key, String kind) {
        Integer known = objects.get(key);
        if (known != null) {
            return known;
        }
        objects.put(key, first.size());
        first.add(mix(kind.hashCode()));
        kinds.add(kind);
        return first.size() - 1;
    }

    void fact(String what, int... about) {
        facts.add(new Fact(what, about));
    }

    byte[] bytes() {
        long[] colours = coloured();
        Integer[] order = new Integer[colours.length];
        Arrays.setAll(order, i -> i);
        Arrays.sort(order, (a, b) -> Long.compare(colours[a], colours[b]));
        int[] numbers = new int[order.length];
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < order.length; i++) {
            numbers[order[i]] = i;
            text.append(kinds.get(order[i])).append('\n');
        }
        String[] lines = new String[facts.size()];
        for (int i = 0; i < lines.length; i++) {
            StringBuilder line = new StringBuilder(facts.get(i).what);
            for (int object : facts.get(i).objects) {
                line.append('\u0001').append(numbers[object]);
            }
            lines[i] = line.append('\u0002').toString();
        }
        Arrays.sort(lines);
        for (String line : lines) {
            text.append(line);
        }
        return text.toString().getBytes(StandardCharsets.UTF_8);
    }

    private long[] coloured() {
        long[] colours = first.stream().mapToLong(Long::longValue).toArray();
        int tied = refine(colours);
        while (tied >= 0) {
            colours[tied] = mix(colours[tied] ^ SET_APART);
            tied = refine(colours);
        }
        return colours;
    }

    /** Refines until no more objects are distinguished. Returns the first of those with the least colour that several have; -1 where none is left. */
    private int refine(long[] colours) {
        int distinct = 0;
        while (true) {
            long[] sorted = colours.clone();
            Arrays.sort(sorted);
            int now = 0;
            long least = 0;
            boolean isTied = false;
            for (int i = 0; i < sorted.length; i++) {
                boolean same = i > 0 && sorted[i] == sorted[i - 1];
                now += same ? 0 : 1;
                if (same && !isTied) {
                    isTied = true;
                    least = sorted[i];
                }
            }
            if (!isTied || now == distinct) {
                return isTied ? indexOf(colours, least) : -1;
            }
            distinct = now;
            next(colours);
        }
    }

    private void next(long[] colours) {
        long[] next = new long[colours.length];
        for (int i = 0; i < next.length; i++) {
            next[i] = mix(colours[i]);
        }
        for (Fact fact : facts) {
            long seen = fact.hash;
            for (int object : fact.objects) {
                seen = mix(seen * 31 + colours[object]);
            }
            for (int i = 0; i < fact.objects.length; i++) {
                next[fact.objects[i]] += mix(seen + i);
            }
        }
        System.arraycopy(next, 0, colours, 0, next.length);
    }

    private static int indexOf(long[] colours, long colour) {
        int i = 0;
        while (colours[i] != colour) {
            i++;
        }
        return i;
    }

    private static long mix(long n) {
        long x = (n + FACTOR) * 0xbf58476d1ce4e5b9L;
        x = (x ^ (x >>> 27)) * 0x94d049bb133111ebL;
        return x ^ (x >>> 31);
    }
}
