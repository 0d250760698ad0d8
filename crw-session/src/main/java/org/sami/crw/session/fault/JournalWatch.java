package org.sami.crw.session.fault;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Objects;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Priority;

/** Looks whether a journal's file is still where it was, and whether its disk has room. For one thread, which a disk that hangs may keep. */
final class JournalWatch {
    private static final System.Logger LOG = System.getLogger(JournalWatch.class.getName());

    private final Path file;
    private final Bytes bytes;
    private final HealthModel health;
    private final Object identity;
    private final DiskSpaceWatch room = new DiskSpaceWatch();

    /** How large the journal is. */
    @FunctionalInterface
    interface Bytes {
        long get() throws IOException;
    }

    /** Watches a file that is there. */
    JournalWatch(Path file, Bytes bytes, HealthModel health) throws IOException {
        this.file = file;
        this.bytes = bytes;
        this.health = health;
        identity = identity();
    }

    private Object identity() throws IOException {
        Object key = Files.readAttributes(file, BasicFileAttributes.class).fileKey();
        return key == null ? file : key; // some systems know none
    }

    void look(long atMillis) {
        if (isThere()) {
            health.over(HealthKind.JOURNAL, file.toString());
        } else {
            health.report(HealthFault.of(
                            HealthKind.JOURNAL,
                            file.toString(),
                            Priority.CRITICAL,
                            "The journal's file is gone: nothing of this session outlives the program",
                            "Bring it back if it was moved; else end the missions and begin a new session")
                    .withDetails("Missions go on. \"" + file
                            + "\" is no longer there: its disk was taken out, or it was deleted or moved"));
        }
        try {
            long free = Files.getFileStore(folder()).getUsableSpace();
            room.look(atMillis, bytes.get(), free)
                    .ifPresentOrElse(health::report, () -> health.over(HealthKind.DISK, ""));
        } catch (
                IOException unknown) { // the folder is gone, which is said, or the journal fails, which is said as well
            LOG.log(Level.DEBUG, "the room for {0} is not known: {1}", file, unknown.getMessage());
        }
    }

    private boolean isThere() {
        try {
            return Objects.equals(identity, identity());
        } catch (IOException gone) {
            return false;
        }
    }

    private Path folder() {
        return Objects.requireNonNullElse(file.toAbsolutePath().getParent(), file);
    }
}
