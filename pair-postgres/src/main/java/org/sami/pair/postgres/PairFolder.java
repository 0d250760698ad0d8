package org.sami.pair.postgres;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** The folder of a pair on one base: its settings, secrets and database. Only its owner may read it. */
public final class PairFolder {
    private static final String SETTINGS = "pair.properties";
    private static final String PASSWORDS = "pgpass";
    private static final int LOG_LINES = 3;

    private final Path folder;

    /** The folder, which need not exist yet. */
    public PairFolder(Path folder) {
        this.folder = folder.toAbsolutePath().normalize();
    }

    /** Its path. */
    public Path path() {
        return folder;
    }

    /** Whether this base is one of a pair. */
    public boolean isThere() {
        return Files.exists(folder.resolve(SETTINGS));
    }

    /** Whether nothing is in it, or it is not there. */
    boolean isFree() throws IOException {
        return content().isEmpty();
    }

    /** What a pair has in it, of which some may not be there. */
    List<Path> own() throws IOException {
        Set<Path> files = Set.of(folder.resolve(SETTINGS), certificate(), key(), passwords(), log(), data());
        return content().stream()
                .filter(each ->
                        files.contains(each) || each.getFileName().toString().startsWith("data."))
                .toList();
    }

    private List<Path> content() throws IOException {
        if (!Files.exists(folder)) {
            return List.of();
        }
        try (Stream<Path> inside = Files.list(folder)) {
            return inside.toList();
        }
    }

    /** The last lines that PostgreSQL wrote, for people. */
    String endOfLog() {
        try {
            List<String> lines = Files.readAllLines(log());
            return String.join(" / ", lines.subList(Math.max(0, lines.size() - LOG_LINES), lines.size()));
        } catch (IOException unreadable) {
            return "nothing";
        }
    }

    Path data() {
        return folder.resolve("data");
    }

    Path log() {
        return folder.resolve("postgres.log");
    }

    Path certificate() {
        return folder.resolve("pair.crt");
    }

    Path key() {
        return folder.resolve("pair.key");
    }

    Path passwords() {
        return folder.resolve(PASSWORDS);
    }

    /**
     * How this base sees the pair.
     *
     * @throws PairException if there is no pair, or the file is damaged
     */
    public PairSettings settings() throws PairException {
        if (!isThere()) {
            throw new PairException(
                    folder + " holds no pair: 'crw pair init HOST' makes one, 'crw pair join FILE' joins one");
        }
        Path file = folder.resolve(SETTINGS);
        Properties values = read(file);
        try {
            return new PairSettings(
                    required(values, "here", file),
                    required(values, "other", file),
                    Integer.parseInt(required(values, "port", file)),
                    WhenCut.parse(required(values, "when-cut", file)));
        } catch (IllegalArgumentException unfit) {
            throw new PairException(file + ": " + unfit.getMessage(), unfit);
        }
    }

    /** Where PostgreSQL's programs are, where they were chosen. */
    Optional<Path> programs() throws PairException {
        Path file = folder.resolve(SETTINGS);
        return Files.exists(file)
                ? Optional.ofNullable(read(file).getProperty("postgres")).map(Path::of)
                : Optional.empty();
    }

    /** Writes everything but the database. */
    void write(PairSettings settings, PairSecrets secrets, Path programs) throws IOException {
        PrivateFile.makeFolder(folder);
        PrivateFile.write(certificate(), secrets.certificate());
        PrivateFile.write(key(), secrets.key());
        PrivateFile.write(
                passwords(),
                "*:*:*:" + Roles.ADMIN + ":" + secrets.admin() + "\n*:*:*:" + Roles.SESSION + ":" + secrets.session()
                        + "\n*:*:*:" + Roles.REPLICA + ":" + secrets.replica() + "\n");
        write(settings, programs);
    }

    private void write(PairSettings settings, @Nullable Path programs) throws IOException {
        Properties values = new Properties();
        values.setProperty("here", settings.here());
        values.setProperty("other", settings.other());
        values.setProperty("port", Integer.toString(settings.port()));
        values.setProperty("when-cut", settings.whenCut().text());
        if (programs != null) {
            values.setProperty("postgres", programs.toString());
        }
        PrivateFile.write(folder.resolve(SETTINGS), text(values));
    }

    /** Replaces the settings of a pair that is here. */
    void replace(PairSettings settings) throws IOException {
        write(settings, programs().orElse(null));
    }

    static String text(Properties values) throws IOException {
        StringWriter text = new StringWriter();
        values.store(text, null);
        return text.toString();
    }

    static Properties read(Path file) throws PairException {
        try {
            Properties values = new Properties();
            values.load(new StringReader(Files.readString(file)));
            return values;
        } catch (IOException | IllegalArgumentException unreadable) {
            throw new PairException(file + " cannot be read: " + unreadable.getMessage(), unreadable);
        }
    }

    static String required(Properties values, String name, Path file) throws PairException {
        String value = values.getProperty(name);
        if (value == null || value.isBlank()) {
            throw new PairException(file + " lacks '" + name + "'");
        }
        return value;
    }

    /** Deletes a file, or a folder with all that is in it, where it is there. */
    static void delete(Path path) throws IOException {
        if (!Files.exists(path)) {
            return;
        }
        Files.walkFileTree(path, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.delete(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path each, @Nullable IOException fault) throws IOException {
                if (fault != null) {
                    throw fault;
                }
                Files.delete(each);
                return FileVisitResult.CONTINUE;
            }
        });
    }
}
