package org.sami.pair.postgres;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.List;
import org.sami.journal.postgres.Connections;
import org.sami.journal.postgres.DatabaseFaults;
import org.sami.journal.postgres.PairSetting;

/** The database of one base of a pair, as programs of PostgreSQL keep it: made, copied from the other base, started, stopped. For one thread. */
public final class PairDatabase {
    private static final int QUICK_SECONDS = 60;
    private static final int COPY_SECONDS = 1800;

    /** What both bases set, in the file that a copy takes along. Times are short, so that a cut shows before a lease ends. */
    private static final String SETTINGS = """

        # Of a pair of bases (SAMI)
        unix_socket_directories = ''
        ssl = on
        wal_keep_size = 1GB
        client_connection_check_interval = 2s
        max_wal_senders = 6
        wal_sender_timeout = 1500ms
        wal_receiver_timeout = 2s
        wal_receiver_status_interval = 1s
        wal_retrieve_retry_interval = 500ms
        hot_standby_feedback = on
        max_standby_streaming_delay = 1s
        shared_buffers = 64MB
        """;

    private final PairFolder folder;
    private final Programs programs;
    private final PairSettings settings;

    private PairDatabase(PairFolder folder, Programs programs, PairSettings settings) {
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
        return new PairDatabase(folder, programs(folder), settings);
    }

    private static Programs programs(PairFolder folder) throws PairException {
        return folder.programs().isPresent()
                ? Programs.in(folder.programs().get())
                : Programs.installed().orElseThrow(() -> new PairException(Programs.HOW_TO_GET));
    }

    /**
     * Makes and starts the database of a new pair; nothing is left where it fails.
     *
     * @throws PairException if there is a pair in the folder, or PostgreSQL refuses
     */
    public static PairDatabase make(PairFolder folder, Programs programs, PairSettings settings, PairSecrets secrets)
            throws IOException {
        PairDatabase made = begun(folder, programs, settings, secrets);
        try {
            made.initialize(secrets);
            made.start();
            made.makeRoles(secrets);
            return made;
        } catch (IOException | RuntimeException fault) {
            made.undo();
            throw fault;
        }
    }

    /**
     * Makes and starts the replica of the other base's database; nothing is left where it fails.
     *
     * @throws PairException if there is a pair in the folder, or the other base is not reached
     */
    public static PairDatabase join(PairFolder folder, Programs programs, Invitation invitation) throws IOException {
        PairDatabase made = begun(folder, programs, invitation.settings(), invitation.secrets());
        try {
            made.copyFromOther(folder.data());
            made.start();
            return made;
        } catch (IOException | RuntimeException fault) {
            made.undo();
            throw fault;
        }
    }

    private static PairDatabase begun(PairFolder folder, Programs programs, PairSettings settings, PairSecrets secrets)
            throws IOException {
        if (folder.isThere()) {
            throw new PairException(folder.path()
                    + " holds a pair already; 'crw pair status' says which, 'crw pair leave' gives it up");
        }
        if (!folder.isFree()) {
            throw new PairException(folder.path() + " is not empty: a pair needs a folder of its own");
        }
        folder.write(settings, secrets, programs.folder());
        return new PairDatabase(folder, programs, settings);
    }

    private void undo() {
        try {
            delete();
        } catch (IOException left) {
            System.getLogger(PairDatabase.class.getName())
                    .log(System.Logger.Level.WARNING, "{0} was left: {1}", folder.path(), left.getMessage());
        }
    }

    private void initialize(PairSecrets secrets) throws IOException {
        Path password = folder.path().resolve("admin.tmp");
        PrivateFile.write(password, secrets.admin() + "\n");
        try {
            run(
                    "the database cannot be made",
                    QUICK_SECONDS,
                    List.of(
                            "initdb",
                            "--pgdata=" + folder.data(),
                            "--username=" + Roles.ADMIN,
                            "--pwfile=" + password,
                            "--auth=scram-sha-256",
                            "--encoding=UTF8",
                            "--locale=C",
                            "--data-checksums"));
        } finally {
            Files.deleteIfExists(password);
        }
        Files.writeString(folder.data().resolve("postgresql.conf"), SETTINGS, StandardOpenOption.APPEND);
        Files.writeString(folder.data().resolve("pg_hba.conf"), access());
    }

    private String access() {
        StringBuilder lines = new StringBuilder("# Of a pair of bases (SAMI)\nhost all all 127.0.0.0/8 scram-sha-256\n"
                + "host replication " + Roles.REPLICA + " 127.0.0.0/8 scram-sha-256\n");
        for (String host : List.of(settings.here(), settings.other())) {
            String machine = PairSettings.inAccessList(host);
            lines.append("hostssl ")
                    .append(Roles.DATABASE)
                    .append(' ')
                    .append(Roles.SESSION)
                    .append(' ')
                    .append(machine);
            lines.append(" scram-sha-256\nhostssl replication ")
                    .append(Roles.REPLICA)
                    .append(' ')
                    .append(machine);
            lines.append(" scram-sha-256\n");
        }
        return lines.toString();
    }

    private void makeRoles(PairSecrets secrets) throws IOException {
        PairConnections connections = new PairConnections(folder, settings);
        try {
            try (Connection admin = connections.asAdmin("postgres")) {
                Connections.run(
                        admin,
                        "CREATE ROLE " + Roles.SESSION + " LOGIN PASSWORD '" + secrets.session()
                                + "' IN ROLE pg_monitor");
                Connections.run(
                        admin,
                        "CREATE ROLE " + Roles.REPLICA + " LOGIN REPLICATION PASSWORD '" + secrets.replica() + "'");
                Connections.run(admin, "CREATE DATABASE " + Roles.DATABASE + " OWNER " + Roles.SESSION);
                Connections.run(
                        admin,
                        "ALTER DATABASE " + Roles.DATABASE + " SET " + PairSetting.NAME + " = '"
                                + settings.whenCut().text() + "'");
                Connections.run(admin, "GRANT ALTER SYSTEM ON PARAMETER synchronous_standby_names TO " + Roles.SESSION);
            }
            try (Connection admin = connections.asAdmin(Roles.DATABASE)) {
                Connections.run(admin, "GRANT EXECUTE ON FUNCTION pg_reload_conf() TO " + Roles.SESSION);
                Connections.run(admin, "GRANT EXECUTE ON FUNCTION pg_promote(boolean, integer) TO " + Roles.SESSION);
            }
            try (Connection session = connections.own()) {
                StandbySign.makeTable(session);
            }
        } catch (SQLException fault) {
            throw new PairException("the database cannot be set up: " + DatabaseFaults.words(fault), fault);
        }
    }

    /** Copies the other base's database as it is now into a folder that is not there, as its replica. */
    private void copyFromOther(Path data) throws IOException {
        String source = "host=" + settings.other() + " port=" + settings.port() + " user=" + Roles.REPLICA
                + " sslmode=verify-ca sslrootcert='" + folder.certificate() + "' passfile='" + folder.passwords()
                + "' connect_timeout=5";
        run(
                "the database of " + settings.other() + " cannot be copied",
                COPY_SECONDS,
                List.of(
                        "pg_basebackup",
                        "--dbname=" + source,
                        "--pgdata=" + data,
                        "--wal-method=stream",
                        "--checkpoint=fast"));
        Files.writeString(
                data.resolve("postgresql.auto.conf"),
                "primary_conninfo = '" + (source + " application_name=" + StandbySign.NAME).replace("'", "''") + "'\n");
        Files.writeString(data.resolve("standby.signal"), "");
    }

    /**
     * Makes this base's database anew as the replica of the other's. The database that it had is kept beside it, as it was.
     *
     * @return where the earlier database is
     */
    public Path copyAgain(String suffix) throws IOException {
        Path anew = folder.path().resolve("data.new");
        delete(anew);
        try {
            copyFromOther(anew);
        } catch (IOException fault) {
            delete(anew);
            throw fault;
        }
        if (isRunning()) {
            stop();
        }
        Path kept = folder.path().resolve("data." + suffix);
        Files.move(folder.data(), kept);
        Files.move(anew, folder.data());
        start();
        return kept;
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
                + " -c ssl_cert_file=" + folder.certificate() + " -c ssl_key_file=" + folder.key();
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
            delete(own);
        }
        if (folder.isFree()) {
            Files.deleteIfExists(folder.path());
        }
    }

    private void run(String what, int seconds, List<String> command) throws IOException {
        programs.run(what, folder.passwords(), seconds, command);
    }

    private static void delete(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return;
        }
        Files.walkFileTree(folder, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.delete(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path each, java.io.IOException fault) throws IOException {
                if (fault != null) {
                    throw fault;
                }
                Files.delete(each);
                return FileVisitResult.CONTINUE;
            }
        });
    }
}
