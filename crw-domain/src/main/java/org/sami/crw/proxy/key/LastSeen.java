package org.sami.crw.proxy.key;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.OwnerOnlyFile;

/**
 * When this base was linked to each boat last, by its own clock: the file {@code seen} next to the keys, a line for each boat. Nothing depends on it: what cannot
 * be read or written is left out. Safe for use by several threads.
 */
public final class LastSeen {
    private static final int MOST = 1000;

    private final Path file;

    /** Of the keys in a folder. */
    public LastSeen(Path folder) {
        file = folder.resolve("seen");
    }

    /** Notes that a link to a boat was made. */
    public void note(Fingerprint boat, long timeMillis) {
        synchronized (LastSeen.class) { // boats are linked by a thread each
            Map<Fingerprint, Long> seen = all();
            seen.put(boat, timeMillis);
            if (seen.size() <= MOST) {
                write(seen);
            }
        }
    }

    private void write(Map<Fingerprint, Long> seen) {
        StringBuilder text = new StringBuilder();
        seen.forEach((one, time) -> text.append(one).append(' ').append(time).append('\n'));
        try {
            OwnerOnlyFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            // the disk is full or read-only, which the session reports: a link does not wait for it
        }
    }

    /** The times, in ms since 1970, of all boats of which one is known. */
    public Map<Fingerprint, Long> all() {
        Map<Fingerprint, Long> seen = new TreeMap<>();
        try {
            if (Files.exists(file)) {
                String text = new String(OwnerOnlyFile.read(file), StandardCharsets.UTF_8);
                text.lines().forEach(line -> take(line, seen));
            }
        } catch (IOException e) {
            seen.clear();
        }
        return seen;
    }

    private static void take(String line, Map<Fingerprint, Long> into) {
        int between = line.indexOf(' ');
        try {
            into.put(
                    Fingerprint.parse(line.substring(0, Math.max(0, between))),
                    Long.parseLong(line.substring(between + 1)));
        } catch (IllegalArgumentException damaged) {
            // that boat's time is not known
        }
    }
}
