package org.sami.pair.postgres;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** PostgreSQL's own programs, as they are installed. They run as the user; as root in a user namespace of their own, since they refuse root. */
public final class Programs {
    /** What is said where there are none. */
    public static final String HOW_TO_GET =
            "PostgreSQL 15 or later is not installed: 'sudo apt install postgresql', or name the folder of its programs"
                    + " by --postgres";

    private static final Path DEBIAN = Path.of("/usr/lib/postgresql");
    private static final List<String> NEEDED = List.of("initdb", "pg_ctl", "pg_basebackup", "postgres");
    private static final int LEAST_VERSION = 15;
    private static final int MOST_LINES = 4;

    private final Path folder;

    private Programs(Path folder) {
        this.folder = folder;
    }

    /**
     * The programs in a folder.
     *
     * @throws PairException if one is missing
     */
    public static Programs in(Path folder) throws PairException {
        for (String name : NEEDED) {
            if (!Files.isExecutable(folder.resolve(name))) {
                throw new PairException(folder + " has no program '" + name + "' of PostgreSQL");
            }
        }
        return new Programs(folder);
    }

    /** The newest that are installed; empty where there are none. */
    public static Optional<Programs> installed() {
        List<Path> folders = new ArrayList<>();
        if (Files.isDirectory(DEBIAN)) {
            try (Stream<Path> versions = Files.list(DEBIAN)) {
                versions.filter(version -> version.getFileName().toString().matches("\\d+"))
                        .filter(version -> number(version) >= LEAST_VERSION)
                        .sorted(Comparator.comparingInt(Programs::number).reversed())
                        .forEach(version -> folders.add(version.resolve("bin")));
            } catch (IOException unreadable) {
                return Optional.empty();
            }
        }
        Arrays.stream(Optional.ofNullable(System.getenv("PATH")).orElse("").split(":"))
                .filter(text -> !text.isEmpty())
                .map(Path::of)
                .forEach(folders::add);
        return folders.stream()
                .filter(each -> NEEDED.stream().allMatch(name -> Files.isExecutable(each.resolve(name))))
                .findFirst()
                .map(Programs::new);
    }

    /** Those with which the pair of a folder was made, else the newest. */
    static Programs of(PairFolder folder) throws PairException {
        return folder.programs().isPresent()
                ? in(folder.programs().get())
                : installed().orElseThrow(() -> new PairException(HOW_TO_GET));
    }

    private static int number(Path version) {
        return Integer.parseInt(version.getFileName().toString());
    }

    /** Where they are. */
    Path folder() {
        return folder;
    }

    /**
     * Runs one to its end.
     *
     * @param passwords the file in which it finds passwords
     * @param what is said where it fails
     * @throws PairException if it fails or takes too long, with its last words
     */
    void run(String what, Path passwords, int seconds, List<String> command) throws IOException {
        List<String> whole = new ArrayList<>();
        if (isRoot()) {
            whole.addAll(List.of("unshare", "--user"));
        }
        whole.add(folder.resolve(command.get(0)).toString());
        whole.addAll(command.subList(1, command.size()));
        Path output = Files.createTempFile("sami-pair", ".out");
        try {
            ProcessBuilder builder =
                    new ProcessBuilder(whole).redirectErrorStream(true).redirectOutput(output.toFile());
            builder.environment().put("PGPASSFILE", passwords.toString());
            builder.environment().put("LC_ALL", "C");
            Process process = builder.start();
            process.getOutputStream().close();
            if (!process.waitFor(seconds, TimeUnit.SECONDS)) {
                process.destroyForcibly();
                throw new PairException(what + ": " + command.get(0) + " takes longer than " + seconds + " s");
            }
            if (process.exitValue() != 0) {
                throw new PairException(what + ": " + lastWords(output));
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException(what + ": interrupted");
        } finally {
            Files.deleteIfExists(output);
        }
    }

    private static boolean isRoot() throws IOException {
        Path self = Path.of("/proc/self");
        return Files.exists(self) && Integer.valueOf(0).equals(Files.getAttribute(self, "unix:uid"));
    }

    private static String lastWords(Path output) throws IOException {
        List<String> lines = new String(Files.readAllBytes(output), StandardCharsets.UTF_8)
                .lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .toList();
        return String.join(" / ", lines.subList(Math.max(0, lines.size() - MOST_LINES), lines.size()));
    }
}
