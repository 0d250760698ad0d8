package org.sami.pair.postgres;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The database of one base of a pair, as PostgreSQL's programs start, stop and delete it. For one thread. {@link PairSetup} makes it. */
public final class PairDatabase {
    private static final int QUICK_SECONDS = 60;

    private final PairFolder folder;
    private final Programs programs;
    private final PairSettings settings;

    PairDatabase(PairFolder folder, Programs programs, PairSettings settings) {
        this.folder = folder;
        this.programs = programs;
        this.settings = settings;
    }

    /**
     * The database of this base.
     *
     * @throws PairException if there is no pair here, or its PostgreSQL is gone
     */
    public static PairDatabase of(PairFolder folder) throws PairException {
        PairSettings settings = folder.settings();
        return new PairDatabase(folder, Programs.of(folder), settings);
    }

    /** Whether PostgreSQL runs on it. */
    public boolean isRunning() throws IOException {
        Path pid = folder.data().resolve("postmaster.pid");
        if (!Files.exists(pid)) {
            return false;
        }
        List<String> lines = Files.readAllLines(pid);
        return !lines.isEmpty()
                && lines.get(0).strip().matches("\\d+")
                && ProcessHandle.of(Long.parseLong(lines.get(0).strip()))
                        .filter(ProcessHandle::isAlive)
                        .filter(PairDatabase::mayBePostgres)
                        .isPresent();
    }

    /** After a loss of power another process may have the number. */
    private static boolean mayBePostgres(ProcessHandle process) {
        return process.info()
                .command()
                .map(command -> command.substring(command.lastIndexOf('/') + 1).startsWith("postgres"))
                .orElse(true);
    }

    /** Starts it, and waits until it answers. It runs on when this process ends. */
    public void start() throws IOException {
        String options = "-c listen_addresses=" + settings.listenAt() + " -c port=" + settings.port()
                + " -c ssl_cert_file=" + argument(folder.certificate()) + " -c ssl_key_file=" + argument(folder.key());
        try {
            run(
                    "the database of this base does not start",
                    QUICK_SECONDS,
                    List.of(
                            "pg_ctl",
                            "start",
                            "--wait",
                            "--timeout=" + QUICK_SECONDS / 2,
                            "--pgdata=" + folder.data(),
                            "--log=" + folder.log(),
                            "--options=" + options));
        } catch (PairException fault) {
            throw new PairException(fault.getMessage() + "; its log ends with: " + folder.endOfLog(), fault);
        }
    }

    /** A path as one word of the shell to which pg_ctl gives options. Pairs of earlier builds lack these settings in their files. */
    private static String argument(Path path) {
        return "'" + path.toString().replace("'", "'\\''") + "'";
    }

    /** Has it read its settings and its access list again; connections go on. */
    void reload() throws IOException {
        run(
                "the database of this base does not read its settings again",
                QUICK_SECONDS,
                List.of("pg_ctl", "reload", "--pgdata=" + folder.data()));
    }

    /** Stops it; connections are cut. */
    public void stop() throws IOException {
        run(
                "the database of this base does not stop",
                QUICK_SECONDS,
                List.of("pg_ctl", "stop", "--mode=fast", "--pgdata=" + folder.data()));
    }

    /** Stops it and deletes what a pair has in its folder, with its database; the folder too where nothing else is in it. */
    public void delete() throws IOException {
        if (isRunning()) {
            stop();
        }
        for (Path own : folder.own()) {
            PairFolder.delete(own);
        }
        if (folder.isFree()) {
            Files.deleteIfExists(folder.path());
        }
    }

    private void run(String what, int seconds, List<String> command) throws IOException {
        programs.run(what, folder.passwords(), seconds, command);
    }
}
