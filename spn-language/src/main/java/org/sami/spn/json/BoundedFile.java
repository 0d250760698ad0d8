package org.sami.spn.json;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads whole files that may be of any size, or without an end such as a device, and refuses what no sane one has. */
public final class BoundedFile {
    /** A project, one of its plans, a domain's file: 500 times the largest that is known. */
    public static final long PROJECT_BYTES = 64L << 20;

    /** Locations, answers, runs: what people write or programs of theirs export. */
    public static final long DATA_BYTES = 64L << 20;

    /** Settings, addresses. */
    public static final long SETTINGS_BYTES = 1L << 20;

    private BoundedFile() {}

    /**
     * All bytes of a file.
     *
     * @param limit how many it may have at most, below 2^31
     * @throws FileTooLargeException if it has more
     */
    public static byte[] bytes(Path file, long limit) throws IOException {
        check(file, limit);
        try (InputStream in = Files.newInputStream(file)) {
            byte[] read = in.readNBytes((int) limit + 1);
            if (read.length > limit) {
                throw tooLarge(file, limit);
            }
            return read;
        } catch (OutOfMemoryError none) {
            throw beyondMemory(file);
        }
    }

    /**
     * The text of a file in UTF-8, without a byte order mark.
     *
     * @param limit how many bytes it may have at most, below 2^31
     * @throws java.nio.charset.CharacterCodingException if it is no UTF-8
     * @throws FileTooLargeException if it has more
     */
    public static String text(Path file, long limit) throws IOException {
        byte[] bytes = bytes(file, limit);
        try {
            return JsonText.decode(bytes);
        } catch (OutOfMemoryError none) {
            throw beyondMemory(file);
        }
    }

    /** Refuses a file that says itself that it is larger; a device, which does not say it, is left to the reading. */
    public static void check(Path file, long limit) throws IOException {
        if (Files.isRegularFile(file) && Files.size(file) > limit) {
            throw tooLarge(file, limit);
        }
    }

    /**
     * Makes something of a file, for which the memory may not suffice.
     *
     * @throws FileTooLargeException if it does not; what was made meanwhile is let go
     */
    public static <T> T making(Path file, Work<T> work) throws IOException {
        try {
            return work.make();
        } catch (OutOfMemoryError none) {
            throw beyondMemory(file);
        }
    }

    /** Makes something of a file. */
    @FunctionalInterface
    public interface Work<T> {
        /** Makes it. */
        T make() throws IOException;
    }

    private static FileTooLargeException tooLarge(Path file, long limit) {
        String size = limit < 1 << 20 ? limit + " bytes" : (limit >> 20) + " MB";
        return new FileTooLargeException(file + " is larger than " + size + ", and is not read");
    }

    private static FileTooLargeException beyondMemory(Path file) {
        long most = Runtime.getRuntime().maxMemory() >> 20;
        return new FileTooLargeException(file + " needs more memory than the " + most
                + " MB that this program may use (more: JAVA_OPTS=-Xmx4g)");
    }
}
