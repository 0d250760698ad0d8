package org.sami.crw.gui.start;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The file {@code open-session} of a data directory: the name of the journal whose session is not finished. One that cannot be understood is set aside under
 * another name, and the newest journal is taken for the unfinished one.
 */
final class OpenSession {
    private static final String NAME = "open-session";
    private static final String SUFFIX = ".journal";
    private static final int MOST_BYTES = 1000;
    private static final int MOST_SET_ASIDE = 1000;

    private final Path file;
    private final Path sessions;

    /**
     * What the file says.
     *
     * @param journal of the session that is not finished; empty for none
     * @param trouble what was wrong with the file and where it is now, one sentence without a full stop; empty text where nothing was
     */
    record Entry(Optional<Path> journal, String trouble) {}

    /**
     * The file of a directory; it need not be there.
     *
     * @param sessions where the journals are
     */
    OpenSession(Path folder, Path sessions) {
        file = folder.resolve(NAME);
        this.sessions = sessions;
    }

    /** A session is open from now on: after a power failure the file has the old name or the new one. */
    void write(Path journal) throws IOException {
        Path part = file.resolveSibling("." + NAME + ".part"); // the directory belongs to one process at a time
        try (FileChannel channel = FileChannel.open(
                part, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE)) {
            ByteBuffer name =
                    StandardCharsets.UTF_8.encode(journal.getFileName().toString());
            while (name.hasRemaining()) {
                channel.write(name);
            }
            channel.force(true);
        }
        Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    /** Reads it, and sets it aside where it is damaged. */
    Entry read() throws IOException {
        if (!Files.exists(file)) {
            return new Entry(Optional.empty(), "");
        }
        Optional<String> damage;
        try {
            String name =
                    Files.size(file) > MOST_BYTES ? "" : Files.readString(file).strip();
            damage = damage(name);
            if (damage.isEmpty()) {
                return new Entry(Optional.of(sessions.resolve(name)), "");
            }
        } catch (CharacterCodingException notText) {
            damage = Optional.of("is not UTF-8 text");
        }
        Optional<Path> newest = newest();
        Path aside = setAside();
        if (newest.isPresent()) {
            write(newest.get()); // it stays on offer until it is finished, or a session begins again
        }
        return new Entry(
                newest,
                file.toAbsolutePath() + " " + damage.get() + " and was set aside as "
                        + aside.getFileName() + "; "
                        + newest.map(one -> "the newest journal is " + one.getFileName())
                                .orElse("there is no journal in " + sessions.toAbsolutePath()));
    }

    private Optional<String> damage(String name) throws IOException {
        if (Files.size(file) == 0 || (Files.size(file) <= MOST_BYTES && name.isEmpty())) {
            return Optional.of("is empty");
        }
        Path journal;
        try {
            journal = Path.of(name);
        } catch (InvalidPathException noName) {
            return Optional.of("names no file");
        }
        if (name.isEmpty() || journal.getNameCount() != 1 || !name.endsWith(SUFFIX)) {
            return Optional.of("names no journal");
        }
        return Files.isRegularFile(sessions.resolve(name))
                ? Optional.empty()
                : Optional.of("names a journal that is not there, " + name + ",");
    }

    private Path setAside() throws IOException {
        for (int i = 1; i < MOST_SET_ASIDE; i++) {
            Path aside = file.resolveSibling(NAME + ".damaged" + (i == 1 ? "" : "-" + i));
            if (!Files.exists(aside)) {
                return Files.move(file, aside);
            }
        }
        return Files.move(file, file.resolveSibling(NAME + ".damaged"), StandardCopyOption.REPLACE_EXISTING);
    }

    /** The journal that was written to last. */
    private Optional<Path> newest() throws IOException {
        try (Stream<Path> all = Files.list(sessions)) {
            return all.filter(journal -> journal.toString().endsWith(SUFFIX) && Files.isRegularFile(journal))
                    .max(Comparator.comparing((Path journal) -> journal.toFile().lastModified())
                            .thenComparing(Comparator.naturalOrder()));
        }
    }

    /** No session is open any longer. */
    void delete() throws IOException {
        Files.deleteIfExists(file);
    }
}
