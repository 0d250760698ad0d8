package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Things by their ids, which are greater than 0: a hash table without an object for each entry, as states are copied hundreds of thousands of
 * times a second in searches. In no order.
 */
public final class ById<T> {
    private static final int SMALLEST = 8;
    /** Times 2 to the 64, odd. */
    private static final long GOLDEN_RATIO = 0x9E3779B97F4A7C15L;

    private long[] ids; // 0 = free; a power of two, at most three quarters of it in use
    private @Nullable Object[] things;
    private int size;

    /** Without a thing yet. */
    ById() {
        this(0);
    }

    /**
     * Without a thing yet.
     *
     * @param room for so many things there is room at once
     */
    ById(int room) {
        int length = SMALLEST;
        while (isFull(room, length)) {
            length *= 2;
        }
        ids = new long[length];
        things = new Object[length];
    }

    private static boolean isFull(int size, int length) {
        return size * 4L > length * 3L;
    }

    /** What has that id; null if nothing has. */
    @SuppressWarnings("unchecked") // only put writes things
    public @Nullable T get(long id) {
        return (T) things[find(id)];
    }

    /** Puts something in, in place of what had its id. */
    public void put(long id, T thing) {
        int at = find(id);
        if (ids[at] == 0) {
            if (isFull(++size, ids.length)) {
                grow(ids.length * 2);
                at = find(id);
            }
            ids[at] = id;
        }
        things[at] = Objects.requireNonNull(thing, "thing");
    }

    /** Takes out what has that id. */
    public void remove(long id) {
        int gap = find(id);
        if (ids[gap] == 0) {
            return;
        }
        size--;
        int mask = ids.length - 1;
        for (int at = gap + 1 & mask; ids[at] != 0; at = at + 1 & mask) {
            int home = slot(ids[at]);
            if ((at - home & mask) >= (at - gap & mask)) { // it was put behind the gap for want of room
                ids[gap] = ids[at];
                things[gap] = things[at];
                gap = at;
            }
        }
        ids[gap] = 0;
        things[gap] = null;
    }

    /** How many things there are. */
    public int size() {
        return size;
    }

    /** All things, in no order. */
    @SuppressWarnings("unchecked") // only put writes things
    public List<T> all() {
        List<T> all = new ArrayList<>(size);
        for (Object thing : things) {
            if (thing != null) {
                all.add((T) thing);
            }
        }
        return all;
    }

    private void grow(int length) {
        long[] oldIds = ids;
        Object[] oldThings = things;
        ids = new long[length];
        things = new Object[length];
        for (int i = 0; i < oldIds.length; i++) {
            if (oldIds[i] != 0) {
                int at = find(oldIds[i]);
                ids[at] = oldIds[i];
                things[at] = oldThings[i];
            }
        }
    }

    /** Where the id is, or would be put. */
    private int find(long id) {
        int mask = ids.length - 1;
        int at = slot(id);
        while (ids[at] != 0 && ids[at] != id) {
            at = at + 1 & mask;
        }
        return at;
    }

    /**
     * Multiplied by the golden ratio, ids that follow one another lie far apart. With their last bits alone they would lie in one row without a gap, and
     * {@link #remove} would go through all of it.
     */
    private int slot(long id) {
        return (int) ((id * GOLDEN_RATIO) >>> 32) & ids.length - 1;
    }
}
